#pragma once

#include <cstdint>

namespace flying {

/// What solves have taken.
struct SolveCounts
{
    std::int64_t accepted = 0; ///< islands whose impulses of the step before were right already
    std::int64_t solved = 0;   ///< islands that were solved to rounding
    std::int64_t unsolved = 0; ///< islands of which no solution was found
    std::int64_t swept = 0;    ///< islands that ended with what sweeps could do
    std::int64_t sweeps = 0;   ///< over all points of an island
    std::int64_t factorisations = 0;
};

} // namespace flying
