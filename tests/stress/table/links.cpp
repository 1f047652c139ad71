// Bodies that hold each other: chains of links, rings poured into a bin. What their time is, is told and decides
// nothing.

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numbers>

#include <fmt/format.h>

#include "math/random.hpp"
#include "math/rotation.hpp"
#include "table/trials.hpp"

namespace flying::stress {
namespace {

double seconds_of_computing()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

constexpr double k_knob = 0.10; // radii, in a link's own unit
constexpr double k_hold = 0.14; // of the inside of the jaw

/// A bar with a knob at its right end and a jaw at its left that holds such a knob; its knob lies one unit right of its
/// jaw.
PolygonDef link_shape()
{
    std::vector<Vec2> outline;
    const auto arc = [&](const Vec2& centre, double radius, double from, double to, int count) {
        for (int k = 0; k <= count; ++k) {
            const double angle = from + (to - from) * k / count;
            outline.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
        }
    };
    constexpr double k_pi = std::numbers::pi;
    const Vec2 knob(1.0, 0.0);
    arc(knob, k_knob, -k_pi + 0.3, k_pi - 0.3, 10);         // round the knob, from below the neck to above it
    arc(Vec2::Zero(), 0.30, 0.1, k_pi - 0.35, 8);           // over the back of the jaw
    arc(Vec2::Zero(), k_hold, k_pi - 0.5, -k_pi + 0.5, 10); // inside it, back again
    arc(Vec2::Zero(), 0.30, -k_pi + 0.35, -0.1, 8);         // under the back of the jaw
    return {outline, {}};
}

/// Links in a straight line that leaves the last one, which is fixed, at an angle.
struct Chain
{
    int links = 30;
    double angle = 0.0; ///< from the level, downwards [rad]
    double friction = 0.3;
    double restitution = 0.2;
};

struct Pulled
{
    double overlap = 0.0; ///< over the smaller size
    int loose = 0;        ///< knobs that have left their jaws
    double seconds = 0.0; ///< of computing for a simulated second, the worst
};

Pulled pull(const Chain& chain, double until)
{
    Scene scene = over_floor(chain.restitution, chain.friction);
    scene.world.box = BoxDef{{-40.0, -40.0}, {40.0, 40.0}};
    // Given about the jaw's centre, moved to the centroid: where that is, the world says
    BodyDef one;
    one.shape = link_shape();
    scene.bodies = {one};
    const World probe = world_of(scene);
    const Vec2 corner = std::get<Polygon>(probe.shape(0)).vertices()[0];
    const Vec2 centroid = std::get<PolygonDef>(one.shape).vertices[0] - corner;
    const Rotation turned = Rotation::of(chain.angle);
    scene.bodies.clear();
    for (int k = 0; k <= chain.links; ++k) {
        one.position = turned * (centroid + Vec2(static_cast<double>(k), 0.0));
        one.angle = chain.angle;
        one.is_static = k == chain.links; // held by the last one's jaw
        scene.bodies.push_back(one);
    }
    World world = world_of(scene);
    const double started = seconds_of_computing();
    run_to(world, until);
    Pulled pulled;
    pulled.seconds = (seconds_of_computing() - started) / until;
    pulled.overlap = deepest_overlap(world);
    for (int k = 0; k < chain.links; ++k) {
        const Pose holder = pose_of(world.state(k + 1));
        const Pose held = pose_of(world.state(k));
        const double apart = (held * Vec2(Vec2(1.0, 0.0) - centroid) - holder * Vec2(-centroid)).norm();
        pulled.loose += apart > k_hold ? 1 : 0;
    }
    return pulled;
}

Reached chains(const Share&)
{
    const Chain all[] = {
        {}, {30, 0.5, 0.3, 0.2}, {30, 1.5, 0.3, 0.0}, {30, 0.0, 0.0, 0.0}, {30, 0.2, 1.0, 0.5}, {10, 0.0, 0.3, 0.2}};
    constexpr double k_until = 3.0;
    Reached reached;
    double worst = 0.0;
    int loose = 0;
    for (const Chain& chain : all) {
        const Pulled pulled = pull(chain, k_until);
        reached.value = std::max(reached.value, pulled.overlap);
        worst = std::max(worst, pulled.seconds);
        loose += pulled.loose;
    }
    if (loose > 0) reached.value = std::max(reached.value, 1.0); // the deepest overlap has been, and is gone
    reached.amount = fmt::format("six chains of 10 or 30 links, let go at several angles, {} s", k_until);
    reached.remark =
        fmt::format("{} joints came loose; at most {:.2g} s of computing for a simulated second; under 1 s was the aim",
                    loose, worst);
    return reached;
}

Reached rings(const Share&)
{
    constexpr int k_rings = 150;
    constexpr double k_until = 3.0;
    Reached reached;
    double worst = 0.0;
    const int sides[] = {12, 12, 8, 20};
    for (int run = 0; run < 4; ++run) {
        Scene scene = over_floor(0.2, run == 3 ? 0.5 : 0.0);
        scene.world.box = BoxDef{{0.0, 0.0}, {10.0, 60.0}};
        PolygonDef ring;
        ring.holes.emplace_back();
        for (int k = 0; k < sides[run]; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / sides[run];
            ring.vertices.push_back(0.4 * Vec2(std::cos(angle), std::sin(angle)));
            ring.holes[0].push_back(0.3 * Vec2(std::cos(angle), std::sin(angle)));
        }
        Random random(26 + static_cast<std::uint64_t>(run));
        for (int k = 0; k < k_rings; ++k) {
            BodyDef body;
            body.shape = ring;
            body.position = {0.6 + 0.95 * (k % 10) + random.uniform(-0.05, 0.05), 0.6 + 0.95 * (k / 10)};
            scene.bodies.push_back(body);
        }
        World world = world_of(scene);
        const double started = seconds_of_computing();
        run_to(world, k_until);
        worst = std::max(worst, (seconds_of_computing() - started) / k_until);
        reached.value = std::max(reached.value, deepest_overlap(world));
    }
    reached.amount = fmt::format("four times {} rings of 8, 12 or 20 sides, {} s", k_rings, k_until);
    reached.remark = fmt::format("at most {:.2g} s of computing for a simulated second; under 1 s was the aim", worst);
    return reached;
}

constexpr std::array k_trials = {
    Trial{26, "a chain of interlocked links", "overlap over the smaller size", 1e-2, false, "", chains},
    Trial{26, "rings poured", "overlap over the smaller size", 1e-2, false, "", rings},
};

} // namespace

std::span<const Trial> trials_of_links()
{
    return k_trials;
}

} // namespace flying::stress
