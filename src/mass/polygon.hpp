#pragma once

#include "geometry/polygon.hpp"
#include "geometry/shape.hpp"
#include "mass/mass_properties.hpp"

namespace flying {

/// Any simple polygon with its holes taken away, about its area centroid, by signed triangles (eq. polygon.inertia).
/// density  positive  [kg/m^2]
[[nodiscard]] MassProperties polygon_mass(const Polygon& polygon, double density);

/// Disc or polygon, about its centre of mass; a half-plane has infinite mass.
/// density  positive  [kg/m^2]
[[nodiscard]] MassProperties mass_of(const Shape& shape, double density);

} // namespace flying
