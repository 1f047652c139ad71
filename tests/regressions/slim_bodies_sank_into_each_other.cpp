// A step of a heap may end with a little overlap, a small part of the bodies' size. That was their bounding radius, and
// a hundredth of it is half the width of a needle: planks, angles and channels that were poured lay in each other by 1
// to 7 % of the width of their arms.

#include <algorithm>

#include "math/random.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

constexpr double k_length = 0.24; // [m]

/// Of arms of some width [m]
PolygonDef angle(double arm)
{
    constexpr double foot = 0.8 * k_length;
    return {{{0.0, 0.0}, {foot, 0.0}, {foot, arm}, {arm, arm}, {arm, k_length}, {0.0, k_length}}, {}};
}

PolygonDef channel(double arm)
{
    constexpr double leg = 0.6 * k_length;
    return {{{0.0, 0.0},
             {leg, 0.0},
             {leg, arm},
             {arm, arm},
             {arm, k_length - arm},
             {leg, k_length - arm},
             {leg, k_length},
             {0.0, k_length}},
            {}};
}

PolygonDef plank(double width)
{
    return {{{0.0, 0.0}, {k_length, 0.0}, {k_length, width}, {0.0, width}}, {}};
}

/// Sixty of them, poured into a box without rebound, turning as they fall.
Scene pour(const PolygonDef& shape, double friction, std::uint64_t seed)
{
    Random random(seed);
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = 0.0;
    scene.world.friction = friction;
    scene.world.box = BoxDef{{0.0, 0.0}, {2.5, 3.5}};
    for (int k = 0; k < 60; ++k) {
        BodyDef body;
        body.shape = shape;
        body.position = {0.2 + 0.35 * (k % 7), 0.2 + 0.35 * (k / 7)};
        body.angle = random.uniform(0.0, 6.28);
        body.velocity = {random.uniform(-1.0, 1.0), 0.0};
        body.spin = random.uniform(-3.0, 3.0);
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace

TEST_CASE("slim bodies and such with arms that are poured keep apart by a hundredth of their width")
{
    struct Case
    {
        PolygonDef (*make)(double width);
        double width; // [m]
        double friction;
        std::uint64_t seed;
    };
    for (const Case& each :
         {Case{angle, 0.0288, 0.6, 31}, Case{channel, 0.0288, 0.3, 32}, Case{plank, 0.016, 0.3, 33}}) {
        CAPTURE(each.seed);
        World world = world_of(pour(each.make(each.width), each.friction, each.seed));
        double deepest = 0.0;
        for (int k = 1; k <= 90; ++k) {
            REQUIRE_FALSE(world.advance(k / 60.0).has_value());
            deepest = std::max(deepest, deepest_overlap(world));
        }
        CHECK(deepest * bounding_radius(world.shape(0)) < 0.01 * each.width);
        CHECK(world.report().max_overlap < 0.01 * each.width);
    }
}
