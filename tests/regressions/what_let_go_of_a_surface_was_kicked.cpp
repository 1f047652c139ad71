// A disc that slides down another one without friction lets go of it where gravity no longer bends its way enough. In
// a quarter of all steps that let go, it was kicked outwards by up to what gravity gives in a step: the curved way
// isn't followed through a letting go, and the straight way that stood in for it bore the disc to the end of the step.

#include <cmath>

#include "math/random.hpp"
#include "support/bodies.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("a disc that slides down a disc leaves it with the speed of the closed form whatever the step")
{
    const double gravity = 9.81; // [m/s^2]
    Random random(81);
    for (int k = 0; k < 80; ++k) {
        const double below = random.uniform(0.5, 2.0);
        const double above = random.uniform(0.1, 0.6);
        const double start = random.uniform(0.1, 0.6); // from the top [rad]
        const double step = 1.0 / (60.0 + k);
        const double way = below + above;
        Scene scene;
        scene.world.field = UniformField{{0.0, -gravity}};
        scene.world.restitution = 0.0;
        scene.world.friction = 0.0;
        scene.bodies = {still(disc(below, Vec2::Zero())), disc(above, way * Vec2(std::sin(start), std::cos(start)))};
        World world = with_step(scene, step);
        CAPTURE(k);
        for (int i = 1; i < 2000 && world.state(1).position.norm() < 1.02 * way; ++i) run(world, i * step);

        // Its speed is that of the fall, and bends its way as gravity does: cos = 2/3 of that at the start
        const double cosine = 2.0 / 3.0 * std::cos(start);
        const double across = std::sqrt(gravity * way * cosine) * cosine;
        CHECK(std::abs(world.state(1).velocity.x() / across - 1.0) < 4e-3);
    }
}
