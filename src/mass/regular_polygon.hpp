#pragma once

#include "mass/mass_properties.hpp"

namespace flying {

// [mass.regular-polygon.declared]
/// Regular polygon about its centre: I = (m l^2 / 24) (1 + 3 cot^2(pi/n)), l its side,
/// written without l (eq. regular.inertia).
///
/// sides    n >= 3
/// radius   of the circle through the vertices, positive   [m]
/// density  positive                                       [kg/m^2]
[[nodiscard]] MassProperties regular_polygon_mass(int sides, double radius, double density);
// [mass.regular-polygon.declared]

} // namespace flying
