#pragma once

#include "mass/mass_properties.hpp"

namespace flying {

// [mass.rectangle.declared]
/// Rectangle about its centre: I = m (w^2 + h^2) / 12 (eq. rectangle.inertia).
/// width, height  positive [m]; density  positive [kg/m^2]
[[nodiscard]] MassProperties rectangle_mass(double width, double height, double density);
// [mass.rectangle.declared]

// [mass.disc.declared]
/// Full disc about its centre: I = m R^2 / 2 (eq. rectangle.disc).
/// radius  positive [m]; density  positive [kg/m^2]
[[nodiscard]] MassProperties disc_mass(double radius, double density);
// [mass.disc.declared]

// [mass.annulus.declared]
/// Ring between two circles about its centre: I = m (a^2 + R^2) / 2
/// (eq. rectangle.annulus).
/// inner, outer  radii, 0 <= a < R [m]; density  positive [kg/m^2]
[[nodiscard]] MassProperties annulus_mass(double inner, double outer, double density);
// [mass.annulus.declared]

// [mass.parallel-axis.declared]
/// Moment of inertia about another axis: I + m d^2 (eq. rectangle.parallel). [kg m^2]
/// distance  of that axis from the centre of mass  [m]
[[nodiscard]] double about_parallel_axis(const MassProperties& body, double distance);
// [mass.parallel-axis.declared]

} // namespace flying
