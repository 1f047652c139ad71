#pragma once

#include <numbers>

#include "mass/disc.hpp"

namespace flying {

/// Rectangle about its centre: I = m (w^2 + h^2) / 12 (eq. rectangle.inertia).
/// width, height  positive [m]; density  positive [kg/m^2]
[[nodiscard]] inline MassProperties rectangle_mass(double width, double height, double density)
{
    const double m = density * (width * height);
    const double moment_of_inertia = m * (width * width + height * height) / 12.0;
    return {m, moment_of_inertia};
}

/// Ring between two circles about its centre: I = m (a^2 + R^2) / 2
/// (eq. rectangle.annulus).
/// inner, outer  radii, 0 <= a < R [m]; density  positive [kg/m^2]
[[nodiscard]] inline MassProperties annulus_mass(double inner, double outer, double density)
{
    // The difference of the squares as a product: a thin ring keeps its digits
    const double squares = (outer - inner) * (outer + inner);
    const double m = density * (std::numbers::pi * squares);
    const double moment_of_inertia = 0.5 * m * (inner * inner + outer * outer);
    return {m, moment_of_inertia};
}

/// Moment of inertia about another axis: I + m d^2 (eq. rectangle.parallel). [kg m^2]
/// distance  of that axis from the centre of mass  [m]
[[nodiscard]] inline double about_parallel_axis(const MassProperties& body, double distance)
{
    return body.moment_of_inertia + body.mass * (distance * distance);
}

} // namespace flying
