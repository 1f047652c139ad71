#pragma once

#include "geometry/polygon.hpp"

namespace flying {

/// `between` stands on the way from one point to another, off the line between them by rounding alone.
///
/// reach  greatest distance of the points from the origin of their frame, which decides how coarse rounding is [m]
[[nodiscard]] bool is_straight_between(const Vec2& from, const Vec2& between, const Vec2& to, double reach);

/// The same convex polygon without the vertices at which its boundary goes straight on, to rounding: every vertex that
/// is left is a corner, and no two sides stand in one line. The others keep their order and their coordinates; a
/// polygon that has corners only comes back as it is. The surface moves by rounding at most,
/// `tolerance::coordinate_rounding`. The time grows with the number of vertices, on straight sides with its square.
///
/// polygon  convex to rounding
[[nodiscard]] Polygon without_straight_vertices(const Polygon& polygon);

} // namespace flying
