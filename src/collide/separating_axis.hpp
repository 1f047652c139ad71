#pragma once

// The normals on which two convex polygons are compared, and the one along which they are furthest apart, or overlap
// least.

#include "collide/contact.hpp"
#include "geometry/disc.hpp"
#include "geometry/half_plane.hpp"
#include "geometry/polygon.hpp"
#include "math/rotation.hpp"

#include <optional>

namespace flying {

/// Whose edge an axis stands on.
enum class Owner
{
    a,
    b
};

/// The line on which two convex polygons are compared: the outward normal of one edge.
/// What lies behind the edge has a negative separation.
struct Axis
{
    Owner owner = Owner::a;
    int edge = 0;            ///< of the owner
    int vertex = 0;          ///< of the other polygon: the one furthest behind the edge
    double separation = 0.0; ///< of that vertex from the edge's line [m]
};

/// Where B lies as A sees it: a_from_b * p is B's point p in A's frame. Positions are subtracted before anything is
/// rounded to their size, so that two bodies far from the world's origin see each other as sharply as near it.
[[nodiscard]] Pose relative_pose(const Pose& world_from_a, const Pose& world_from_b);

/// Separation along the outward normal of one edge.
///
/// owner             convex polygon whose edge it is
/// edge              its index
/// other             convex polygon
/// owner_from_other  where the other lies in the owner's frame
/// The field `owner` of the result says a.
[[nodiscard]] Axis axis_of_edge(const Polygon& owner, int edge, const Polygon& other, const Pose& owner_from_other);

/// The axis of greatest separation among all edges of two convex polygons. Where it is positive, a line parts the
/// polygons and their distance is at least that; where it is negative, the normal times it is the shortest push that
/// parts them (chapter 6). Axes of A win ties. Time linear in the number of edges.
[[nodiscard]] Axis greatest_separation(const Polygon& a, const Polygon& b, const Pose& a_from_b);

/// Of each of two convex polygons, the edge whose axis has the greatest separation among its own.
struct BestEdges
{
    int of_a = 0;
    int of_b = 0;
    double lead = 0.0; ///< by which the separation of each exceeds those of its polygon's other edges, at least [m]
};

/// Time linear in the number of edges. Where two edges share the greatest separation, the first wins, and the lead is
/// 0.
[[nodiscard]] BestEdges best_edges(const Polygon& a, const Polygon& b, const Pose& a_from_b);

/// The one of two edges with the greater separation, A's where they are equal.
[[nodiscard]] Axis greater_of(const BestEdges& edges, const Polygon& a, const Polygon& b, const Pose& a_from_b);

/// The axis of greatest separation of two that overlap by more than a depth; nothing where they don't.
///
/// guess  edges that may part them: where one does, no other is looked at. The same comes out to the bit for any others
/// depth  half of it is more than rounding explains [m]
[[nodiscard]] std::optional<Axis> overlapping_axis(const Polygon& a, const Polygon& b, const Pose& a_from_b,
                                                   const BestEdges& guess, double depth);

} // namespace flying
