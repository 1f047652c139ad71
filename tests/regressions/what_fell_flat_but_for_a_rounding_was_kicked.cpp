// A box that fell flat, but for a tilt that only rounding explains, was stopped at one corner of its foot in flight,
// and at the other one a billionth of a second later, in a step: one after another, two such blows leave it a spin,
// with which it rose on its edge. So a rod that fell beside its mirror image toppled, and a box that slid down a wall
// left it.

#include <algorithm>
#include <cmath>

#include "math/random.hpp"
#include "support/bodies.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("a box that falls flat but for a rounding stops dead")
{
    Random random(47);
    for (int k = 0; k < 60; ++k) {
        CAPTURE(k);
        Scene scene;
        scene.world.field = UniformField{Vec2(0.0, -9.81)};
        scene.world.restitution = 0.0;
        scene.world.friction = random.below(2) == 0 ? 0.0 : random.uniform(0.1, 0.8);
        scene.bodies.push_back(still(rectangle(20.0, 1.0, {0.0, -0.5})));
        const double width = random.uniform(0.1, 1.0);
        const double height = random.uniform(0.1, 1.0);
        BodyDef box = rectangle(width, height, {random.uniform(-3.0, 3.0), 0.5 * height + random.uniform(0.05, 0.8)});
        box.angle = (random.below(2) == 0 ? -1.0 : 1.0) * std::pow(10.0, -random.uniform(7.0, 12.0));
        scene.bodies.push_back(box);
        World world = world_of(scene);
        double spin = 0.0;
        for (int step = 1; step <= 60; ++step) {
            run(world, step / 60.0);
            spin = std::max(spin, std::abs(world.state(1).spin));
        }
        CHECK(spin < 1e-3);
        CHECK(std::abs(world.state(1).angle) < 1e-9);
    }
}
