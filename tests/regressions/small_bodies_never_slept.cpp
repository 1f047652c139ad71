// A box with sides of 10 cm that lay on a floor, and moved by no bit, was looked at and solved for in every step, for
// ever, and all larger bodies of its world with it: steps are halved where there are small bodies, and only a whole
// step put anything to sleep. A world of 20,000 such boxes took 11 ms a step.

#include <vector>

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

[[nodiscard]] int awake_in(const World& world)
{
    int awake = 0;
    for (int k = 1; k < world.body_count(); ++k) awake += world.mover(k) == BodyMover::asleep ? 0 : 1;
    return awake;
}

} // namespace

TEST_CASE("what lies still sleeps, however small it is")
{
    for (const double side : tried({0.1, 1e-3, 0.01, 0.02, 0.05, 0.12, 0.125, 0.3})) {
        for (const int count : {1, 5}) {
            CAPTURE(side);
            CAPTURE(count);
            Scene scene = on_a_floor(0.0, 0.3);
            for (int k = 0; k < count; ++k) scene.bodies.push_back(rectangle(side, side, Vec2(3.0, (k + 0.5) * side)));
            World world = world_of(scene);
            run(world, 0.2);
            CHECK(awake_in(world) == 0);
        }
    }
}

TEST_CASE("small bodies sleep beside one that rolls, and so do large ones")
{
    Scene scene = on_a_floor(0.0, 0.3);
    for (int k = 0; k < 50; ++k) {
        const double side = k % 5 == 0 ? 1.0 : 0.1;
        scene.bodies.push_back(rectangle(side, side, Vec2(3.0 + 1.2 * k, 0.5 * side)));
    }
    scene.bodies.push_back(disc(0.0625, Vec2(-100.0, 0.0625), Vec2(2.0, 0.0)));
    scene.bodies.back().spin = -32.0;
    World world = world_of(scene);
    run(world, 4.0);
    CHECK(awake_in(world) == 1);
    const BodyState state = world.state(world.body_count() - 1);
    CHECK(state.position.x() == doctest::Approx(-92.0).epsilon(1e-12));
    CHECK(state.velocity.x() == doctest::Approx(2.0).epsilon(1e-12));
}
