// What the report says of how steps were made: how islands were solved, and what was done to them besides.

#include <doctest/doctest.h>

#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

Scene room(double width)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = 0.0;
    scene.world.friction = 0.5;
    scene.world.box = BoxDef{{0.0, 0.0}, {width, 100.0}};
    return scene;
}

} // namespace

TEST_CASE("where nothing leans on anything, a report has no account of rest")
{
    Scene scene = room(4.0);
    scene.world.restitution = 1.0;
    scene.bodies.push_back(disc(0.5, {2.0, 5.0}));
    World world = world_of(scene);
    run(world, 3.0);
    CHECK_FALSE(world.report().rest.has_value());
}

TEST_CASE("a stack is solved to rounding, island by island, and nothing else is done to it")
{
    Scene scene = room(8.0);
    for (int k = 0; k < 5; ++k) {
        scene.bodies.push_back(rectangle(1.0, 1.0, {2.0, 0.5 + k}));
        scene.bodies.push_back(rectangle(1.0, 1.0, {6.0, 0.5 + k}));
    }
    World world = world_of(scene, EngineChoice::automatic, {"sleeping"});
    run(world, 1.0);
    const RestAccount rest = world.report().rest.value();
    CHECK(rest.islands == 2 * 60); // two stacks, sixty steps
    CHECK(rest.solved >= rest.islands);
    CHECK(rest.swept + rest.unsolved + rest.parts + rest.projected + rest.limited == 0);
    CHECK(rest.energy_limited == 0.0);
}

TEST_CASE("what is done to islands besides is counted where it has to be done")
{
    // More bodies than are solved whole, on the move: sweeps, which leave overlap to the projection
    Scene heap = room(20.0);
    for (int k = 0; k < 440; ++k) heap.bodies.push_back(disc(0.45, {0.55 + 0.95 * (k % 20), 0.46 + 0.93 * (k / 20)}));
    World world = world_of(heap);
    run(world, 1.0);
    CHECK(world.report().rest.value().swept > 0);
    CHECK(world.report().rest.value().projected > 0);

    // A box that slides down the edge of a step, and strikes within steps: parts
    Scene edge = room(8.0);
    edge.bodies = {still(rectangle(2.0, 1.0, {1.0, 0.5})), rectangle(1.0, 0.5, {1.9, 1.25}, {0.9, 0.0})};
    World tips = world_of(edge);
    run(tips, 3.0);
    CHECK(tips.report().rest.value().parts > 0);
}
