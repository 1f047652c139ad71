#pragma once

#include <span>

#include "geometry/polygon.hpp"

namespace flying {

/// Area, centroid and second moment of a region of the plane.
struct AreaMoments
{
    double area = 0.0;            ///< positive if it turns counter-clockwise [m^2]
    Vec2 centroid = Vec2::Zero(); ///< [m]
    double second_moment = 0.0;   ///< squared distance from there, over the area [m^4]
};

/// Moments of the region inside one ring, by signed triangles about a vertex of its own (so that a ring far from the
/// origin loses nothing), summed with twice the digits: each number returned is within 2 ulp of that of the given
/// vertices, unless the triangles cancel to less than 2^-40 of their sizes. A ring that turns clockwise counts
/// negatively; the centroid of a ring without area is its first vertex.
///
/// ring  three vertices or more; its size to the fourth power neither overflows nor underflows  [m]
[[nodiscard]] AreaMoments moments_of_ring(std::span<const Vec2> ring);

/// Moments of a polygon, its holes taken away.
[[nodiscard]] AreaMoments moments_of(const Polygon& polygon);

} // namespace flying
