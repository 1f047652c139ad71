#pragma once

#include <cmath>

#include "math/tolerance.hpp"

namespace flying {

/// Bound on the second derivative of a gap: of a point of body P over a line that turns
/// with body Q.  [m/s^2]
///
/// acceleration  of P relative to Q, its size                     [m/s^2]
/// speed         bound on the relative speed of their positions   [m/s]
/// distance      bound on the distance of their positions         [m]
/// arm           of the point, from P's position                  [m]
/// spin_p, spin_q                                                 [rad/s]
[[nodiscard]] inline double bend_of_point(double acceleration, double speed,
                                          double distance, double arm,
                                          double spin_p, double spin_q)
{
    const double q = std::abs(spin_q);
    const double of_flight = acceleration + 2.0 * q * speed + q * q * distance;

    // Q sees the arm turn by the difference of the spins alone
    const double turn = spin_p - spin_q;
    return (of_flight + turn * turn * arm) * (1.0 + tolerance::k_bend_margin);
}

} // namespace flying
