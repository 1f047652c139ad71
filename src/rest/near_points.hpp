#pragma once

#include <optional>

#include "collide/contact.hpp"
#include "collide/separating_axis.hpp"
#include "geometry/shape.hpp"
#include "math/rotation.hpp"

namespace flying {

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

/// The points at which two convex shapes touch, overlap, or might touch soon: of two polygons those over the edge where
/// the separation is greatest. Nothing where that is no answer, and outlines tell (rest/outline_points.hpp): the corner
/// nearest to that edge stands beyond its ends.
///
/// margin  points further apart than this make no contact [m]
/// memory  knows the edges, which must then be the best still, or learns them; the points are the same to the bit
[[nodiscard]] std::optional<Manifold> near_points(const Shape& a, const Pose& pose_a, const Shape& b,
                                                  const Pose& pose_b, double margin, NearMemory& memory);

} // namespace flying
