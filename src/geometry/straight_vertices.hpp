#pragma once

#include "geometry/polygon.hpp"

namespace flying {

/// The same convex polygon without the vertices at which its boundary goes straight on, to rounding: every vertex that
/// is left is a corner, and no two sides stand in one line. The others keep their order and their coordinates; a
/// polygon that has corners only comes back as it is. The surface moves by rounding at most,
/// `tolerance::coordinate_rounding`. The time grows with the number of vertices, on straight sides with its square.
///
/// polygon  convex to rounding
[[nodiscard]] Polygon without_straight_vertices(const Polygon& polygon);

/// The boundary of a polygon, convex or not, leads from one of its vertices straight to another, over any number of
/// vertices that stand on the line to rounding.
///
/// from, to  coordinates of the two vertices, to the bit [m]
[[nodiscard]] bool has_straight_side(const Polygon& polygon, const Vec2& from, const Vec2& to);

} // namespace flying
