// Whom a body may touch in a step is asked of the speeds with which the step begins. A brick that a blow threw further
// than that flew into others that its island knew nothing of, by more than a hundredth of its size. Both go back now,
// to where they met; it was thought once that they had come nearer all the time, and where the blow came late in the
// step, they went back to before it.

#include <numbers>

#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A pyramid of square bricks that a heavy ball strikes on its flank.
Scene pyramid(int rows, double restitution, double mass, double speed)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = restitution;
    scene.world.friction = 0.5;
    scene.bodies.push_back(still(rectangle(400.0, 1.0, {0.0, -0.5})));
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k < rows - row; ++k)
            scene.bodies.push_back(rectangle(0.4, 0.4, {(k - (rows - row - 1) / 2.0) * 0.44, 0.2 + 0.4 * row}));
    }
    scene.bodies.push_back(disc(0.2, {-rows * 0.44, 0.4 * rows * 0.3}, {speed, 0.0}));
    scene.bodies.back().mass = mass;
    return scene;
}

} // namespace

TEST_CASE("bricks that a blow throws out of a pyramid keep apart from those that they fly past")
{
    struct Case
    {
        int rows;
        double restitution;
        double mass;  // [kg]
        double speed; // [m/s]
    };
    for (const Case& each : {Case{10, 0.3, 2.0, 10.0}, Case{8, 0.5, 1.0, 20.0}, Case{6, 0.2, 5.0, 15.0},
                             Case{12, 0.3, 3.0, 12.0}, Case{10, 0.6, 2.0, 10.0}, Case{6, 0.0, 5.0, 20.0}}) {
        CAPTURE(each.rows);
        CAPTURE(each.restitution);
        World world = world_of(pyramid(each.rows, each.restitution, each.mass, each.speed));
        REQUIRE_FALSE(world.advance(2.0).has_value());
        CHECK(world.report().max_overlap < 0.01 * 0.2 * std::numbers::sqrt2);
    }
}
