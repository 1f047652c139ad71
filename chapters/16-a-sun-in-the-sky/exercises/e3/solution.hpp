#pragma once

#include <algorithm>
#include <cmath>

/// The eccentricity of an ellipse on which a body needs the time t from the distance r_1 to r_2, on its way out.
///
/// mu  strength of the centre [m^3/s^2]; a  half of the long axis [m]; r_1 < r_2  below 2 a [m]; t  [s]
inline double eccentricity_from(double mu, double a, double r_1, double r_2, double t)
{
    const auto time_at = [&](double ecc, double r) {
        const double E = std::acos(std::clamp((1.0 - r / a) / ecc, -1.0, 1.0));
        return std::sqrt(a / mu) * a * (E - ecc * std::sin(E));
    };

    // At any distance the speed is the same for every eccentricity, by the energy; the larger it is, the more of that
    // speed leads outwards. So the time only falls, and halving finds the one place.
    double low = std::max(std::abs(1.0 - r_1 / a), std::abs(1.0 - r_2 / a));
    double high = 1.0;
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (!(low < middle && middle < high)) return low;
        (time_at(middle, r_2) - time_at(middle, r_1) > t ? low : high) = middle;
    }
}
