#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

/// What statistical mechanics says of hard discs in equilibrium, with diameter, mass and k T as units.
namespace flying::gas {

/// Virial coefficients B_k / B_2^(k - 1), k = 2 ... 10 (Clisby, McCoy, "Ninth and tenth order virial coefficients for hard
/// spheres in D dimensions", J. Stat. Phys. 122, 2006). At packing 0.3 the eleventh term is below 1e-4 and known to a tenth
/// of itself: it is taken as 0.0109.
inline constexpr std::array<double, 10> k_virial = {1.0,       0.78200444, 0.53223180, 0.33355604, 0.1988425,
                                                    0.1148728, 0.0649930,  0.0362193,  0.0199537,  0.0109};

/// Compressibility factor P A / (N k T) at packing `h`: 1 + sum of b_k (2 h)^(k - 1).
inline double series(double h)
{
    double sum = 1.0;
    double power = 1.0;
    for (const double b : k_virial) {
        power *= 2.0 * h;
        sum += b * power;
    }
    return sum;
}

/// Its first and second derivatives by the packing.
inline double series_slope(double h)
{
    double sum = 0.0;
    double power = 1.0;
    for (std::size_t k = 0; k < k_virial.size(); ++k) {
        sum += 2.0 * static_cast<double>(k + 1) * k_virial[k] * power;
        power *= 2.0 * h;
    }
    return sum;
}
inline double series_bend(double h)
{
    double sum = 0.0;
    double power = 1.0;
    for (std::size_t k = 1; k < k_virial.size(); ++k) {
        sum += 4.0 * static_cast<double>(k * (k + 1)) * k_virial[k] * power;
        power *= 2.0 * h;
    }
    return sum;
}

/// Collisions of one disc in unit time, diameter and k T / m being 1: 4 (Z - 1) / sqrt(pi).
inline double collision_rate(double z)
{
    return 4.0 * (z - 1.0) / std::sqrt(std::numbers::pi);
}

/// What a closed box of `count` discs falls short of the endless gas: Z of the endless gas less that of the box.
///
/// In the endless gas, the number of discs in any area A fluctuates with variance rho S A, S = 1 / (Z + h Z'). What is
/// counted, Y = rho (Z - 1) for each area, bends upwards with the density, so that the mean over those fluctuations is
/// higher than without by Y'' (rho S / A) / 2. A closed box allows none in the whole of it (Lebowitz, Percus, "Long-range
/// correlations in a closed system", Phys. Rev. 122, 1961). Divided by rho: (2 h Z' + h^2 Z'') S / (2 count).
inline double closed_box_shortfall(double h, int count)
{
    const double slope = series_slope(h);
    const double share = 1.0 / (series(h) + h * slope);
    return (2.0 * h * slope + h * h * series_bend(h)) * share / (2.0 * count);
}

} // namespace flying::gas
