#include "support/worlds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/random.hpp"
#include "math/rotation.hpp"

using namespace flying;
using namespace flying::testing;

// A polygon that rolls down a slope turns about one corner, until the next one strikes. Where that corner came to slip,
// or had slipped and came to hold, the force of a step was sought as if the body didn't turn: without what bends the
// way of its centre, several times as much as it weighs there. So it was thrown up a little once in each turn, and came
// too far: a hexagon by a third. Expected ways are those of steps a 64th as long, which converge.

namespace {

struct Rolling
{
    int sides = 6;
    double slope = 0.5; ///< [rad]
    double friction = 1.0;
    double size = 0.4; ///< [m]
    double mass = 1.0; ///< [kg]
    double angle = 0.0;
    double speed = 0.0; ///< along the slope [m/s]
    double spin = -2.0; ///< [1/s]
};

/// A polygon that stands on one corner at the upper end of a long slab.
Scene scene_of(const Rolling& r)
{
    Scene scene;
    scene.world.field = UniformField{Vec2(0.0, -9.81)};
    scene.world.restitution = 0.0;
    scene.world.friction = r.friction;
    const Rotation world_from_slope = Rotation::of(-r.slope);
    BodyDef slab = still(rectangle(200.0, 1.0, world_from_slope * Vec2(90.0, -0.5)));
    slab.angle = -r.slope;
    scene.bodies.push_back(slab);

    double lowest = 0.0;
    for (int k = 0; k < r.sides; ++k)
        lowest = std::min(lowest, r.size * std::sin(r.angle + 2.0 * std::numbers::pi * k / r.sides));
    BodyDef body;
    body.shape = RegularDef{r.sides, r.size};
    body.mass = r.mass;
    body.position = world_from_slope * Vec2(0.0, -lowest);
    body.angle = r.angle - r.slope;
    body.velocity = world_from_slope * Vec2(r.speed, 0.0);
    body.spin = r.spin;
    scene.bodies.push_back(body);
    return scene;
}

/// How far down the slope it has come.  [m]
double way_of(const Rolling& r, double step, double until)
{
    World world = with_step(scene_of(r), step);
    run(world, until);
    return (Rotation::of(-r.slope) * Vec2(1.0, 0.0)).dot(world.state(1).position);
}

} // namespace

TEST_CASE("a polygon that rolls down a slope comes as far in steps of a sixtieth as in short ones")
{
    Random random(31);
    for (int k = 0; k < 40; ++k) {
        const double sizes[] = {0.2, 0.4, 1.0, 2.0};
        const double masses[] = {0.1, 1.0, 20.0};
        Rolling r;
        r.sides = 3 + k % 10;
        r.slope = random.uniform(0.2, 0.6);
        r.friction = random.uniform(0.3, 1.2);
        r.size = sizes[random.below(4)];
        r.mass = masses[random.below(3)];
        r.angle = random.uniform(0.0, 2.0);
        r.speed = k % 3 == 0 ? random.uniform(0.0, 2.0) : 0.0;
        r.spin = -random.uniform(0.0, 2.0) / r.size;
        CAPTURE(k);
        const double way = way_of(r, 1.0 / 3840.0, 2.0);
        for (const double step : {1.0 / 60.0, 1.0 / 120.0})
            CHECK(std::abs(way_of(r, step, 2.0) - way) < 0.01 * std::max(std::abs(way), r.size));
    }
}

TEST_CASE("a hexagon rolls down a slope for three seconds, and comes no further in long steps")
{
    for (const double friction : {0.8, 1.0, 1.2}) {
        for (const double mass : {0.1, 10.0}) {
            Rolling r;
            r.slope = 0.55;
            r.friction = friction;
            r.mass = mass;
            r.angle = -1.0471975511965979;
            const double way = way_of(r, 1.0 / 3840.0, 3.0);
            CAPTURE(friction);
            CHECK(std::abs(way_of(r, 1.0 / 60.0, 3.0) - way) < 0.01 * way);
        }
    }
}
