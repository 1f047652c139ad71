#pragma once

#include <variant>

#include "geometry/disc.hpp"
#include "geometry/half_plane.hpp"
#include "geometry/polygon.hpp"

namespace flying {

/// Every shape that a body can have. A half-plane is always static.
using Shape = std::variant<Disc, Polygon, HalfPlane>;

/// Radius of the smallest circle about the centre of mass that holds the shape; infinite for a half-plane.  [m]
[[nodiscard]] double bounding_radius(const Shape& shape);
/// The least distance between two parallel lines that have a convex shape between them; infinite for a half-plane.  [m]
[[nodiscard]] double least_width(const Shape& convex);

} // namespace flying
