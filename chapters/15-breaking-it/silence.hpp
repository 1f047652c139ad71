#pragma once

#include <cmath>
#include <limits>

/// What may be concluded where nothing was found.
namespace flying::breaking {


/// The greatest share of cases that can fail, if so many random ones went well, and luck as great as that is no more
/// likely than `alpha`.
///
/// n      cases that were tried, all well, > 0
/// alpha  0 < alpha < 1
[[nodiscard]] inline double share_that_may_fail(double n, double alpha)
{
    return -std::expm1(std::log(alpha) / n); // 1 - alpha^(1/n), without the 1 that would swallow it
}


/// Distance from a number to the next double above it.
/// x  positive and finite
[[nodiscard]] inline double spacing(double x)
{
    return std::nextafter(x, std::numeric_limits<double>::infinity()) - x;
}

} // namespace flying::breaking
