#pragma once

#include "geometry/shape.hpp"

namespace flying {

/// How stout a shape is: the side of the square, or the diameter of the disc, that has as much area for its outline,
/// holes included. Of bars, rings and long arms that is twice their width, wherever they bend; infinite for a
/// half-plane.  [m]
[[nodiscard]] double stoutness(const Shape& shape);

} // namespace flying
