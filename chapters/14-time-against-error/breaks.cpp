// WRONG: an engine is timed against itself, in blocks, on a machine that grows warm.

#include <cstdio>

#include "wrong_blocks.hpp"

using namespace flying::work;

namespace {

double median_of(const std::vector<std::vector<double>>& times, int which)
{
    return spread_of(times[which]).median;
}

} // namespace

int main()
{
    // [time-against-error.breaks]
    DriftingMachine machine;
    const auto clock = [&machine] { return machine.now; };
    const Prepare one = [&machine] { return [&machine] { machine.run(); }; };
    const std::vector<Prepare> twins = {one, one};
    const auto blocks = time_in_blocks(twins, 30, clock);
    machine = {};
    const auto turns = time_in_turn(twins, 30, clock);
    // [time-against-error.breaks]

    std::printf("The same program twice, 30 runs each, each run a hundredth of a second longer than the last\n");
    std::printf("in blocks, the second over the first = %.3f\n", median_of(blocks, 1) / median_of(blocks, 0));
    std::printf("there and back, the second over the first = %.3f\n", median_of(turns, 1) / median_of(turns, 0));
    return 0;
}
