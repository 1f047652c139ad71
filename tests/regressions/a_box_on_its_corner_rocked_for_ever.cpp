// A box that stood on a corner in a gap between two others never came to rest. Its points slipped by less than counts
// as settled, but on so short arms that its centre went ten times as fast: to one side in one step, back in the next,
// since each step began with the impulses that had braked the last one. It kept its whole heap awake.

#include <doctest/doctest.h>

#include "support/poured.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("boxes that are poured come to rest, those on a corner too")
{
    World world = world_of(poured_boxes(400, 14), EngineChoice::rest);
    run(world, 9.0);
    int awake = 0;
    for (int k = 0; k < world.body_count(); ++k) awake += world.mover(k) == BodyMover::rest ? 1 : 0;
    CHECK(awake == 0);
    CHECK(world.report().energy.kinetic == 0.0);
}
