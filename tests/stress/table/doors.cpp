// What a scene may say, and what is refused.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "mass/polygon.hpp"
#include "math/random.hpp"
#include "table/trials.hpp"
#include "world/make_shape.hpp"

namespace flying::stress {
namespace {

/// A star with corners in whole numbers; many of its sides have a corner in the middle, or one that is given twice.
std::vector<Vec2> star(Random& random)
{
    std::vector<Vec2> ring;
    const int corners = 3 + random.below(12);
    for (int k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / corners;
        const double out = random.uniform(200.0, 1000.0);
        // Even, so that the middle of a side is whole, too
        ring.push_back(2.0 * Vec2(std::round(out * std::cos(angle)), std::round(out * std::sin(angle))));
    }
    std::vector<Vec2> more;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2& next = ring[(k + 1) % ring.size()];
        more.push_back(ring[k]);
        if (random.below(4) == 0) more.push_back(ring[k]);
        if (random.below(3) == 0) more.push_back(0.5 * (ring[k] + next));
    }
    if (random.below(2) == 0) std::reverse(more.begin(), more.end());
    return more;
}

struct Moments
{
    long double area = 0.0L;
    long double moment = 0.0L; ///< of area, about the centroid
};

/// Sums of whole numbers, which are exact, put together in long doubles.
Moments exact_moments(const std::vector<Vec2>& ring)
{
    std::int64_t twice_area = 0;
    std::int64_t x6 = 0;
    std::int64_t y6 = 0;
    std::int64_t moment12 = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2& from = ring[k];
        const Vec2& to = ring[(k + 1) % ring.size()];
        const auto ax = static_cast<std::int64_t>(from.x());
        const auto ay = static_cast<std::int64_t>(from.y());
        const auto bx = static_cast<std::int64_t>(to.x());
        const auto by = static_cast<std::int64_t>(to.y());
        const std::int64_t twice = ax * by - ay * bx;
        twice_area += twice;
        x6 += twice * (ax + bx);
        y6 += twice * (ay + by);
        moment12 += twice * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by);
    }
    const long double sign = twice_area < 0 ? -1.0L : 1.0L;
    const auto area2 = static_cast<long double>(twice_area);
    const auto x = static_cast<long double>(x6);
    const auto y = static_cast<long double>(y6);
    const long double about_centroid = static_cast<long double>(moment12) / 12.0L - (x * x + y * y) / (18.0L * area2);
    return {sign * area2 / 2.0L, sign * about_centroid};
}

double ulps(double value, long double truth)
{
    const double ulp = std::nextafter(std::abs(value), std::numeric_limits<double>::infinity()) - std::abs(value);
    return static_cast<double>(std::abs(static_cast<long double>(value) - truth)) / ulp;
}

Reached outlines(const Share&)
{
    Reached reached;
    Random random(6);
    constexpr int k_stars = 20000;
    int refused = 0;
    for (int k = 0; k < k_stars; ++k) {
        const std::vector<Vec2> ring = star(random);
        const Expected<Shape> shape = make_shape(PolygonDef{ring, {}});
        if (!shape) {
            ++refused; // rounding to whole numbers has made it touch itself
            continue;
        }
        const MassProperties found = mass_of(shape.value(), 1.0);
        const Moments truth = exact_moments(ring);
        reached.value = std::max({reached.value, ulps(found.mass, truth.area), ulps(found.moment_of_inertia, truth.moment)});
    }

    // And such that enclose nothing, cross or touch themselves, run back: all refused
    const std::vector<std::vector<Vec2>> bad = {
        {{0, 0}, {1, 0}}, {{0, 0}, {1, 0}, {2, 0}}, {{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {{0, 0}, {2, 0}, {2, 2}, {2, 0}, {0, 2}},
        {{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {-1, 0}, {-1, -1}}, {{1, 1}, {1, 1}, {1, 1}}};
    for (const auto& ring : bad) {
        if (make_shape(PolygonDef{ring, {}})) throw std::runtime_error("an outline that is none is taken");
    }
    reached.amount = fmt::format("{} stars with repeated and flat corners, both ways round; {} outlines that are none, all refused", k_stars - refused,
                                 bad.size());
    return reached;
}

Reached overlaps(const Share&)
{
    Reached reached;
    Random random(14);
    constexpr int k_pairs = 20000;
    int tried = 0;
    for (int k = 0; k < k_pairs; ++k) {
        const double size = std::pow(10.0, random.uniform(-3.0, 3.0));
        Scene scene;
        BodyDef one = disc(size, Vec2::Zero());
        BodyDef two = disc(size * random.uniform(0.1, 1.0), Vec2::Zero());
        if (k % 2 == 1) two.shape = RegularDef{3 + random.below(6), std::get<DiscDef>(two.shape).radius};
        if (k % 4 > 1) one.shape = SquareDef{2.0 * size};
        one.name = "one";
        two.name = "two";
        // Deep enough that no shape gets out of it, a millionth of the size at least
        const double way = random.uniform(0.0, 2.0 * std::numbers::pi);
        const double inner = k % 2 == 1 ? 0.5 : 1.0; // of the smallest polygon's radius
        const double reach = size + inner * (std::holds_alternative<DiscDef>(two.shape) ? std::get<DiscDef>(two.shape).radius
                                                                                       : std::get<RegularDef>(two.shape).radius);
        two.position = reach * (1.0 - std::pow(10.0, -random.uniform(0.0, 6.0))) * Vec2(std::cos(way), std::sin(way));
        two.angle = random.uniform(-3.0, 3.0);
        scene.bodies = {one, two};
        ++tried;
        const Expected<World> world = World::make(scene);
        bool named = false;
        if (!world) {
            for (const Fault& fault : world.faults()) {
                const std::string all = fault.place + fault.found + fault.expected;
                named = named || (all.find("one") != std::string::npos && all.find("two") != std::string::npos);
            }
        }
        reached.value += named ? 0.0 : 1.0;
    }
    reached.amount = fmt::format("{} pairs of 1 mm to 1 km that overlap by a millionth to all of their size", tried);
    return reached;
}

using Setter = std::function<void(Scene&, double)>;

/// One for each number that a scene can hold.
std::vector<Setter> fields()
{
    const auto body = [](Scene& s) -> BodyDef& { return s.bodies[0]; };
    return {
        [=](Scene& s, double x) { body(s).position.x() = x; },
        [=](Scene& s, double x) { body(s).position.y() = x; },
        [=](Scene& s, double x) { body(s).angle = x; },
        [=](Scene& s, double x) { body(s).velocity.x() = x; },
        [=](Scene& s, double x) { body(s).velocity.y() = x; },
        [=](Scene& s, double x) { body(s).spin = x; },
        [=](Scene& s, double x) { body(s).density = x; },
        [=](Scene& s, double x) { body(s).mass = x; },
        [=](Scene& s, double x) { body(s).restitution = x; },
        [=](Scene& s, double x) { body(s).friction = x; },
        [=](Scene& s, double x) { body(s).shape = DiscDef{x}; },
        [=](Scene& s, double x) { body(s).shape = SquareDef{x}; },
        [=](Scene& s, double x) { body(s).shape = RectangleDef{1.0, x}; },
        [=](Scene& s, double x) { body(s).shape = RectangleDef{x, 1.0}; },
        [=](Scene& s, double x) { body(s).shape = TriangleDef{{x, 1.0}, 1.0}; },
        [=](Scene& s, double x) { body(s).shape = TriangleDef{{1.0, 1.0}, x}; },
        [=](Scene& s, double x) { body(s).shape = RegularDef{5, x}; },
        [=](Scene& s, double x) { body(s).shape = PolygonDef{{{x, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, {}}; },
        [=](Scene& s, double x) { body(s).shape = PolygonDef{{{0.0, 0.0}, {1.0, x}, {0.0, 1.0}}, {}}; },
        [](Scene& s, double x) { s.world.field = UniformField{{x, 0.0}}; },
        [](Scene& s, double x) { s.world.field = CentralField{{3.0, 3.0}, x, 0.1}; },
        [](Scene& s, double x) { s.world.field = CentralField{{3.0, 3.0}, 1.0, x}; },
        [](Scene& s, double x) { s.world.field = CentralField{{x, 3.0}, 1.0, 0.1}; },
        [](Scene& s, double x) { s.world.restitution = x; },
        [](Scene& s, double x) { s.world.friction = x; },
        [](Scene& s, double x) { s.world.box->min.x() = x; },
        [](Scene& s, double x) { s.world.box->max.y() = x; },
        [](Scene& s, double x) { s.until = x; },
    };
}

Scene plain_scene()
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -k_gravity}};
    scene.world.restitution = 0.5;
    scene.world.friction = 0.3;
    scene.world.box = BoxDef{{-5.0, -5.0}, {5.0, 5.0}};
    scene.until = 1.0;
    scene.bodies = {rectangle(1.0, 0.5, {0.0, 0.0}, {1.0, 0.0}), disc(0.5, {2.0, 0.0})};
    return scene;
}

/// Every number of every body is one, a second later or where the run says that it can't go on.
bool stays_finite(World& world)
{
    (void)world.advance(1.0, 2000);
    for (int k = 0; k < world.body_count(); ++k) {
        const BodyState s = world.state(k);
        if (!std::isfinite(s.position.sum() + s.velocity.sum() + s.angle + s.spin)) return false;
    }
    return true;
}

Reached numbers(const Share&)
{
    using Limits = std::numeric_limits<double>;
    constexpr double k_values[] = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::denorm_min(), -Limits::denorm_min(),
                                   -0.0, 0.0, 1e308, -1e308, 1e-308, -1e-308, 1e154, 1e-154, 1e100, 1e-100, 1e20, -1.0};
    Reached reached;
    int taken = 0;
    int tried = 0;
    int number = 0;
    for (const Setter& set : fields()) {
        for (const double value : k_values) {
            Scene scene = plain_scene();
            set(scene, value);
            ++tried;
            Expected<World> world = World::make(scene);
            if (!world) continue;
            ++taken;
            if (std::isfinite(value) && stays_finite(world.value())) continue;
            reached.value += 1.0;
            if (reached.remark.empty()) reached.remark = fmt::format("first: field {}, {}", number, value);
        }
        ++number;
    }

    // All at once: a fault for each
    Scene scene = plain_scene();
    scene.bodies[0].position.x() = Limits::quiet_NaN();
    scene.bodies[0].spin = Limits::infinity();
    scene.bodies[1].density = -1.0;
    scene.world.restitution = 2.0;
    scene.until = -1.0;
    const Expected<World> world = World::make(scene);
    if (world || world.faults().size() < 5) throw std::runtime_error("not all faults come at once");
    reached.amount = fmt::format("{} values in {} fields: {} refused, {} run", std::size(k_values), number, tried - taken, taken);
    return reached;
}

constexpr std::array k_trials = {
    Trial{6, "outlines with repeated, flat, reversed corners", "error of the moments in units of the last place", 4.0, false,
          "reduced to a hull, or asserts", outlines},
    Trial{14, "overlapping at the start", "pairs not refused by both names", 0.0, false, "pushed apart, with energy", overlaps},
    Trial{15, "NaN, infinity, 1e-308, 1e308, -0 in any field", "values let in that end in no number", 0.0, false, "asserts", numbers},
};

} // namespace

std::span<const Trial> trials_of_doors()
{
    return k_trials;
}

} // namespace flying::stress
