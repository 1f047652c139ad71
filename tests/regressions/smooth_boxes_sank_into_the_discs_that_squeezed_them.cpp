#include "support/crowds.hpp"

using namespace flying;
using namespace flying::testing;

// In a smooth heap of boxes and discs, boxes sank into their neighbours by half a size. What squeezes a box without
// friction throws it round, by more than a radian in a step, and no pushes along the lines that it has touched on take
// off what it overlaps after that. The step of a heap was made whole nonetheless, and the overlap left.

TEST_CASE("smooth heaps of boxes and discs keep out of each other")
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        CAPTURE(seed);
        World large = world_of(smooth_crowd(300, 14, seed), EngineChoice::rest);
        CHECK(deepest_until(large, 2.5) <= 0.01);
        World small = world_of(smooth_crowd(150, 10, seed), EngineChoice::rest);
        CHECK(deepest_until(small, 2.0) <= 0.01);
    }
}
