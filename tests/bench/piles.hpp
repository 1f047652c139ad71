#pragma once

#include <functional>
#include <string>
#include <vector>

#include "growth.hpp"

namespace flying::bench {

/// What lies and stands, as one engine steps it.
struct PileShowing
{
    std::string engine;
    double milliseconds = 0.0; ///< of computing, a step: median over rounds in which the engines take turns
    double worst = 0.0;        ///< longest single step, settling included [ms]
    long touching = 0;         ///< pairs nearer than a thousandth of their size
    double mean_overlap = 0.0; ///< over those [radii]
    double worst_overlap = 0.0;
};

/// One scene of them in all engines, by steps of 1/60 s in which no body may sleep; then in this engine with sleep.
struct PileComparison
{
    std::string name;
    int settled = 0; ///< steps before the clock runs
    std::vector<PileShowing> showings;
    double asleep_at = -1.0;    ///< all bodies sleep from here on; negative where some never do [s]
    double asleep_after = 0.0;  ///< bodies that sleep in the end, of those that move
    double asleep_micros = 0.0; ///< of computing, a step, from then on [us]
};

/// rounds  in which each engine makes a few steps
/// Piles of 1000 boxes and discs, or of 5000; a stack and a pyramid.
[[nodiscard]] std::vector<PileComparison> measure_piles(Extent extent, int rounds,
                                                        const std::function<void(const std::string&)>& tell);

} // namespace flying::bench
