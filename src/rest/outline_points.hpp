#pragma once

#include "collide/contact.hpp"
#include "math/rotation.hpp"
#include "rest/outline.hpp"

namespace flying {

/// One convex part of one of two bodies that may meet, and the boundary of the whole body.
struct OutlineSide
{
    const Outline& outline;
    int part = 0;
    const Pose& pose;
};

/// The points at which the boundaries of two parts touch, overlap, or might touch soon, where a body is cut into parts
/// or `near_points` leaves it to this: corners of one over sides of the other, and corners over corners. Each corner
/// and side belongs to one part, so that no point is found twice, and none on a cut.
///
/// A corner inside of the other body makes a point with the side that is nearest of those that it faces: a thin wall is
/// left through the side by which it was entered. Of the points, the lowest counts, and the one beside it that is the
/// next lowest along the same normal.
///
/// margin  points further apart than this make no contact [m]
/// touch   distances that rounding explains [m]
[[nodiscard]] Manifold outline_points(const OutlineSide& a, const OutlineSide& b, double margin, double touch);

/// The same of a part and a half-plane: its lowest corners. The normal leads from the half-plane to the part.
[[nodiscard]] Manifold outline_points(const HalfPlane& wall, const OutlineSide& b, double margin);

} // namespace flying
