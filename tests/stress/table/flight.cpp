// Bodies that fly: far away, huge and tiny, thin, fast, spinning.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "math/random.hpp"
#include "stress/random_scenes.hpp"
#include "support/scaled_scene.hpp"
#include "table/trials.hpp"

namespace flying::stress {
namespace {

Reached far_away(const Share&)
{
    // Two discs of one metre meet obliquely, 2^40 m from the origin; everything is given in whole units in the last place
    const double far = std::ldexp(1.0, 40);
    const double ulp = std::ldexp(1.0, 40 - 52);
    const auto rounded = [ulp](double x) { return ulp * std::round(x / ulp); };
    Random random(3);
    Reached reached;
    constexpr int k_pairs = 2000;
    int met = 0;
    for (int k = 0; k < k_pairs; ++k) {
        const double way = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double aside = random.uniform(-0.8, 0.8);
        const Vec2 along(std::cos(way), std::sin(way));
        const Vec2 from = -1.5 * along + aside * perp(along);
        BodyDef flies = disc(0.5, {rounded(from.x()), rounded(from.y())}, along);
        Scene near;
        near.bodies = {flies, disc(0.5, Vec2::Zero())};
        Scene there = near;
        for (BodyDef& body : there.bodies) body.position += Vec2(far, far);
        World here = events_of(near);
        World away = events_of(there);
        run_to(here, 2.0);
        run_to(away, 2.0);
        if (here.collisions() != away.collisions()) throw std::runtime_error("an impact is missed far away");
        met += here.collisions() > 0 ? 1 : 0;
        for (int body = 0; body < 2; ++body) {
            const Vec2 off = away.state(body).position - Vec2(far, far) - here.state(body).position;
            reached.value = std::max(reached.value, off.cwiseAbs().maxCoeff() / ulp);
        }
    }
    reached.amount = fmt::format("{} pairs, {} of them meet", k_pairs, met);
    return reached;
}

Reached scaled(const Share&)
{
    Reached reached;
    int compared = 0;
    std::int64_t impacts = 0;
    for (std::uint64_t seed = 1; seed <= 120; ++seed) {
        const Scene scene = random_scene(seed);
        World plain = events_of(scene);
        if (plain.advance(scene.until, 1000)) continue; // impacts that crowd without end
        if (plain.time() < scene.until) continue;
        impacts += plain.collisions();
        for (const int power : {-100, 100}) {
            const testing::Units units{std::ldexp(1.0, power), std::ldexp(1.0, power), std::ldexp(1.0, -power)};
            World other = events_of(testing::in_units(scene, units));
            (void)other.advance(scene.until * units.time);
            bool same = other.collisions() == plain.collisions();
            for (int k = 0; k < plain.body_count(); ++k) {
                const BodyState one = plain.state(k);
                const BodyState two = other.state(k);
                same = same && two.position == Vec2(units.length * one.position) && two.spin == one.spin / units.time &&
                       two.velocity == Vec2(units.length / units.time * one.velocity) && two.angle == one.angle;
            }
            reached.value += same ? 0.0 : 1.0;
            ++compared;
        }
    }
    reached.amount = fmt::format("{} random scenes, {} impacts before scaling", compared, impacts);
    return reached;
}

Reached slivers(const Share&)
{
    // A plank falls turning on the floor and comes to lie
    Reached reached;
    double worst = 0.0;
    for (int power = 1; power <= 9; ++power) {
        const double thickness = std::pow(10.0, -power);
        Scene scene = over_floor(0.3, 0.5);
        BodyDef plank = rectangle(1.0, thickness, {0.0, 2.0}, {0.3, 0.0});
        plank.angle = 0.4;
        plank.spin = 1.0;
        scene.bodies = {plank};
        World world = world_of(scene);
        run_to(world, 20.0);
        const double sunk = std::abs(world.state(0).position.y() / (0.5 * thickness) - 1.0);
        if (!(sunk <= 0.02) || !(world.state(0).velocity.norm() < 1e-3)) {
            reached.remark = fmt::format("at 1e{} its centre is {:.1e} of the thickness off after 20 s", power, 0.5 * sunk);
            break;
        }
        worst = std::max(worst, sunk);
        reached.value = std::pow(10.0, power);
    }
    if (reached.remark.empty()) reached.remark = fmt::format("sinks in by {:.1e} of the thickness at most", 0.5 * worst);
    reached.amount = "planks of one metre, one tenth to a billionth thick";
    return reached;
}

/// Four thin walls whose corners are open by gaps that no body of size one fits through.
Scene room(double thickness)
{
    Scene scene;
    scene.bodies = {still(rectangle(thickness, 10.9, {-5.0, 0.0})), still(rectangle(thickness, 10.9, {5.0, 0.0})),
                    still(rectangle(9.9, thickness, {0.0, -5.5})), still(rectangle(9.9, thickness, {0.0, 5.5}))};
    return scene;
}

/// Body 4 of such a room bounces until it has had so many impacts, or has left: true where it stays.
bool stays_inside(World& world, std::int64_t impacts)
{
    while (world.collisions() < impacts) {
        const std::int64_t before = world.events();
        if (world.advance(1e9, 200) || world.events() == before) return false;
        const Vec2 place = world.state(4).position;
        if (std::abs(place.x()) > 5.0 || std::abs(place.y()) > 5.5) return false;
    }
    return true;
}

Reached thin_walls(const Share&)
{
    Reached reached;
    constexpr int k_rooms = 200;
    constexpr std::int64_t k_impacts = 1000;
    Random random(7);
    for (int k = 0; k < k_rooms; ++k) {
        Scene scene = room(1e-9);
        BodyDef body = k % 2 == 0 ? disc(0.5, {0.3, 0.2}) : rectangle(1.0, 0.6, {0.3, 0.2});
        const double way = random.uniform(0.0, 2.0 * std::numbers::pi);
        body.velocity = 1e6 * Vec2(std::cos(way), std::sin(way));
        if (k % 4 == 1) body.spin = 1e6;
        scene.bodies.push_back(body);
        World world = events_of(scene);
        if (!stays_inside(world, k_impacts)) reached.value += 1.0;
    }
    reached.amount = fmt::format("{} rooms, {} impacts each", k_rooms, k_impacts);
    return reached;
}

Reached spinning(const Share&)
{
    Reached reached;
    constexpr int k_bars = 400;
    std::int64_t impacts = 0;
    double deepest = 0.0;
    Random random(8);
    for (int k = 0; k < k_bars; ++k) {
        Scene scene = room(0.1);
        BodyDef bar = rectangle(1.0, random.uniform(0.02, 0.5), {random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)});
        const double way = random.uniform(0.0, 2.0 * std::numbers::pi);
        bar.velocity = std::pow(10.0, random.uniform(1.0, 4.0)) * Vec2(std::cos(way), std::sin(way));
        bar.spin = random.below(2) == 0 ? 1e6 : -1e6;
        scene.bodies.push_back(bar);
        World world = events_of(scene);
        const bool stays = stays_inside(world, 50);
        const double overlap = world.report().max_overlap;
        impacts += world.collisions();
        deepest = std::max(deepest, overlap);
        if (!stays || overlap > 1e-9) reached.value += 1.0;
    }
    reached.amount = fmt::format("{} bars at a million radians a second, {} impacts", k_bars, impacts);
    reached.remark = fmt::format("deepest overlap at an impact {:.1e} m", deepest);
    return reached;
}

constexpr std::array k_trials = {
    Trial{3, "far from the origin, 1e12 sizes", "error in units of the last place", 2.0, false, "1e-3 m at 1e7 m", far_away},
    Trial{4, "lengths scaled by 2^100 and 2^-100", "scenes with other bits", 0.0, false, "none passes", scaled},
    Trial{5, "slivers", "length over thickness that lies well", 1e8, true, "5e3, sinking by 14 %", slivers},
    Trial{7, "a million sizes a second at walls of 1e-9", "bodies that got out", 0.0, false, "pass through each other at 60 m/s", thin_walls},
    Trial{8, "bars at a million radians a second", "bars that got into a wall", 0.0, false, "45 degrees a step", spinning},
};

} // namespace

std::span<const Trial> trials_of_flight()
{
    return k_trials;
}

} // namespace flying::stress
