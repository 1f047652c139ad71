#pragma once

#include <cstdint>

namespace flying {

/// What solves have taken.
struct SolveCounts
{
    std::int64_t accepted = 0; ///< groups whose impulses of the step before were right already
    std::int64_t solved = 0;   ///< groups that were solved to rounding
    std::int64_t unsolved = 0; ///< groups of which no solution was found
    std::int64_t swept = 0;    ///< groups that ended with what sweeps could do
    std::int64_t sweeps = 0;   ///< over all points of a group
    std::int64_t factorisations = 0;
};

} // namespace flying
