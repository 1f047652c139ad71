#include <cstdio>

#include "crowd.hpp"

using namespace flying;

namespace {


/// A thousand discs, many of them overlapping: how many of the overlaps does each index
/// find?
void look_once()
{
    const Crowd crowd = make_crowd(1000, 34.5, 6.25, 94);
    const std::size_t by_position = crowd.find(Index::position).size();
    const std::size_t by_velocity = crowd.find(Index::velocity).size();
    std::printf("overlaps found by position = %zu\n", by_position);
    std::printf("overlaps found by velocity = %zu\n", by_velocity);
}



/// Both rooms for ten seconds: what one may look at, and what tells.
void run_both()
{
    std::printf("\nfiled under   energy before   energy after   overlapping now\n");
    for (const Index index : {Index::position, Index::velocity}) {
        Crowd crowd = make_crowd(60, 20.0, 6.25, 95);
        const double before = crowd.energy();
        for (int k = 0; k < 600; ++k) crowd.step(index, 1.0 / 60.0);
        const std::size_t overlapping = crowd.find(Index::position).size();
        std::printf("%-10s %15.4f J %12.4f J %12zu\n",
                    index == Index::position ? "positions" : "velocities", before,
                    crowd.energy(), overlapping);
    }
}


} // namespace


int main()
{
    look_once();
    run_both();
}

