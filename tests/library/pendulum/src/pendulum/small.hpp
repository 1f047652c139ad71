#pragma once

#include <cmath>
#include <numbers>

namespace pendulum {

// [small.period]
/// Period of small swings: 2 pi sqrt(l / g).  [s]
/// l  length, positive        [m]
/// g  acceleration, positive  [m/s^2]
[[nodiscard]] inline double small_period(double l, double g)
{
    return 2.0 * std::numbers::pi * std::sqrt(l / g);
}
// [small.period]

} // namespace pendulum
