#pragma once

#include <numbers>

#include "mass/mass_properties.hpp"
#include "math/sine_cosine.hpp"

namespace flying {

/// Regular polygon about its centre: I = (m l^2 / 24) (1 + 3 cot^2(pi/n)), l its side,
/// written without l (eq. regular.inertia).
///
/// sides    n >= 3
/// radius   of the circle through the vertices, positive   [m]
/// density  positive                                       [kg/m^2]
[[nodiscard]] inline MassProperties regular_polygon_mass(int sides, double radius, double density)
{
    const double n = sides;
    const SineCosine half = sine_cosine(std::numbers::pi / n);

    // Sum n triangles of height R cos(pi/n) on sides of 2 R sin(pi/n)
    const double squared_radius = radius * radius;
    const double area = n * (half.sine * half.cosine) * squared_radius;
    const double m = density * area;

    // Put the side into l^2 (1 + 3 cot^2(pi/n)) / 24: the cotangent goes away
    const double share = 0.5 - half.sine * half.sine / 3.0;
    const double moment_of_inertia = m * squared_radius * share;
    return {m, moment_of_inertia};
}

} // namespace flying
