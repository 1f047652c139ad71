#pragma once

#include "mass/mass_properties.hpp"

namespace flying {

/// Full disc about its centre: I = m R^2 / 2 (eq. rectangle.disc).
/// radius  positive [m]; density  positive [kg/m^2]
[[nodiscard]] MassProperties disc_mass(double radius, double density);

} // namespace flying
