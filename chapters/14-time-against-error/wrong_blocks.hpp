#pragma once

#include "spread.hpp"

namespace flying::work {

// [work.wrong_blocks]
/// WRONG: all runs of the first, then all of the second, and so on.
template <typename Clock>
[[nodiscard]] std::vector<std::vector<double>> time_in_blocks(std::span<const Prepare> prepares, int rounds,
                                                              const Clock& seconds)
{
    std::vector<std::vector<double>> times(prepares.size());
    for (std::size_t k = 0; k < prepares.size(); ++k) {
        for (int round = 0; round < rounds; ++round) {
            const std::function<void()> run = prepares[k]();
            const double start = seconds();
            run();
            times[k].push_back(seconds() - start);
        }
    }
    return times;
}
// [work.wrong_blocks]

// [work.drifting]
/// A machine that grows warm: each run takes `drift` longer than the one before.
struct DriftingMachine
{
    double drift = 0.01; ///< [s]
    double now = 0.0;    ///< what its clock shows [s]
    double took = 1.0;   ///< the run before [s]

    void run()
    {
        took += drift;
        now += took;
    }
};
// [work.drifting]

} // namespace flying::work
