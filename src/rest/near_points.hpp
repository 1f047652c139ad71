#pragma once

#include <span>

#include "collide/contact.hpp"
#include "collide/separating_axis.hpp"
#include "geometry/shape.hpp"
#include "math/rotation.hpp"

namespace flying {

/// One of the two convex parts that may meet: part of a body, or all of it.
struct NearSide
{
    const Shape& shape;
    const Pose& pose;
    std::span<const char> real; ///< for each edge, whether it is a side of the body and no cut; empty where all are
};

/// The points at which two convex parts touch, overlap, or might touch soon. What `make_manifold` finds, and beyond it
/// - what is nearest of two parts where no edge of theirs faces the other within its ends, or a cut alone does: corners
///   near each other, which make a point along the line between them, or a corner over an edge;
/// - where parts overlap over a cut, which is no side of a body: the shortest way out over a side, at one point. Points
///   that stand on a cut and don't overlap belong to the neighbour on the other side of it, and are left out; so is an
///   overlap of less than a sixteenth of the way out, as that of a corner in a notch with a part whose sides are far.
///
/// margin  points further apart than this make no contact [m]
[[nodiscard]] Manifold near_points(const NearSide& a, const NearSide& b, double margin);

/// What the last look at two polygons has found, that the next may use.
struct NearMemory
{
    BestEdges edges;         ///< of the two
    double separation = 0.0; ///< the greatest [m]
    bool knows_edges = false;
    bool knows_separation = false;
};

/// The same to the bit, faster where `memory` knows the edges, which must then be the best still. What it finds is
/// remembered.
[[nodiscard]] Manifold near_points(const NearSide& a, const NearSide& b, double margin, NearMemory& memory);

} // namespace flying
