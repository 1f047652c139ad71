#include "support/crowds.hpp"
#include "support/effort.hpp"

using namespace flying;
using namespace flying::testing;

// Boxes and discs of 1 : 20 that fall into a pit: small ones ended inside large ones, once by half a size. A step that
// is made in parts looks in each of them only for what may meet within the part. A body that is struck in one may well
// get no further in all than it was thought to, and yet meet in the next what nobody expected there. And in heaps of
// some dozens, where points have the lines of push of halfway, these were taken for those that bodies end with; and
// again where no impulses were found, so that sweeps went on with these lines.

TEST_CASE("bodies of all sizes keep out of each other where they fall into a pit")
{
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(tried(20)); ++seed) {
        CAPTURE(seed);
        for (const EngineChoice engine : {EngineChoice::automatic, EngineChoice::rest}) {
            World world = world_of(crowd_of_all_sizes(seed), engine);
            CHECK(deepest_until(world, 3.0) <= 0.01);
        }
    }
}
