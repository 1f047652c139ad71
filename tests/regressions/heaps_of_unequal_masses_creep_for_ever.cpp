// Heaps of more than 64 bodies of very unequal masses crept for ever, by millimetres a second, and never slept: in a
// slow heap, sweeps were content with approaches that were faster than what counts as rest.

#include "support/heaps.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("more than half of the heaps of masses over 1 : 1e4 sleep within 20 s, and none has sunk")
{
    int asleep = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        CAPTURE(seed);
        World world = world_of(heap_of_unequal_masses(100, 1e4, seed));
        run(world, 20.0);
        CHECK(deepest_overlap(world) <= 0.004);
        int awake = 0;
        for (int k = 0; k < world.body_count(); ++k) awake += world.mover(k) != BodyMover::asleep ? 1 : 0;
        if (awake == 0) ++asleep;
    }
    CHECK(asleep >= 5); // 6 of them; none before
}
