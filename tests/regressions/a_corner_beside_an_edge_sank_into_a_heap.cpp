// A heap looks again, where a step ends, only at pairs that may have come to overlap. Of a pair with a single point it
// was thought that all other corners were out of reach. But a corner beyond the end of the edge that it nears is
// clipped, and no point, however near: a box that span past another one sank into it by a twenty-fifth of its size, and
// nobody looked.

#include <doctest/doctest.h>

#include "support/poured.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("no corner of a box that is poured sinks into another unnoticed")
{
    struct Pour
    {
        int count;
        std::uint64_t seed;
    };
    for (const Pour& pour : {Pour{150, 48}, Pour{400, 13}}) {
        CAPTURE(pour.count);
        World world = world_of(poured_boxes(pour.count, pour.seed), EngineChoice::rest);
        run(world, 4.0);
        CHECK(world.report().max_overlap < 0.01 * 0.3);
    }
}
