#pragma once

#include "collide/contact.hpp"
#include "collide/separating_axis.hpp"
#include "geometry/shape.hpp"
#include "math/rotation.hpp"

namespace flying {

/// The points at which two convex shapes touch, overlap, or might touch soon. What `make_manifold` finds, and beyond it
/// what is nearest of two polygons where no edge of theirs faces the other within its ends: corners near each other,
/// which make a point along the line between them, or a corner over an edge.
///
/// margin  points further apart than this make no contact [m]
[[nodiscard]] Manifold near_points(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b,
                                   double margin);

/// What the last look at two polygons has found, that the next may use.
struct NearMemory
{
    BestEdges edges;         ///< of the two
    double separation = 0.0; ///< the greatest [m]
    bool knows_edges = false;
    bool knows_separation = false;
};

/// The separation of two polygons along the edge where it is greatest; that of others counts as nothing. [m]
[[nodiscard]] double find_separation(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b,
                                     NearMemory& memory);

/// The points to the bit as above, faster where `memory` knows the edges, which must then be the best still. What it
/// finds is remembered.
[[nodiscard]] Manifold near_points(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b,
                                   double margin, NearMemory& memory);

} // namespace flying
