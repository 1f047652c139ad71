#pragma once

#include <algorithm>
#include <cmath>

/// How long after its nearest point a body on an ellipse is first at the distance r.   [s]
///
/// mu  strength of the centre [m^3/s^2]; a  half of the long axis [m]; ecc  above 0, below 1
/// r   from a (1 - ecc) to a (1 + ecc) [m]
inline double time_at(double mu, double a, double ecc, double r)
{
    // r = a (1 - ecc cos E)
    const double E = std::acos(std::clamp((1.0 - r / a) / ecc, -1.0, 1.0));
    return std::sqrt(a / mu) * a * (E - ecc * std::sin(E));
}
