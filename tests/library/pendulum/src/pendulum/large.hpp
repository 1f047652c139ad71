#pragma once

#include <cmath>

#include "pendulum/small.hpp"

namespace pendulum {

// [large.mean]
/// Arithmetic-geometric mean of two positive numbers: each round doubles the digits.
[[nodiscard]] inline double agm(double a, double b)
{
    while (std::abs(a - b) > 1e-15 * a) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return a;
}
// [large.mean]

// [large.period]
/// Period of swings of any width: that of small ones over agm(1, cos(theta / 2)).  [s]
/// l      length, positive                       [m]
/// g      acceleration, positive                 [m/s^2]
/// theta  angle of the widest point, 0 < theta < pi  [rad]
[[nodiscard]] inline double large_period(double l, double g, double theta)
{
    return small_period(l, g) / agm(1.0, std::cos(0.5 * theta));
}
// [large.period]

} // namespace pendulum
