#pragma once

#include <vector>

#include "collide/contact.hpp"
#include "geometry/polygon.hpp"
#include "math/rotation.hpp"

namespace flying {

// [collide.vertex_edge.cross.declared]
/// Segments a-b and c-d cross: each has its ends strictly on different sides of the other. Exact.
[[nodiscard]] bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
// [collide.vertex_edge.cross.declared]

// [collide.vertex_edge.entered.declared]
/// A corner has entered a body over one of its edges: both sides of the corner cross the edge, and the corner lies on
/// its inner side, which is its left. Exact.
///
/// before, corner, after  three vertices of a ring, in order
/// from, to               ends of the other body's edge
[[nodiscard]] bool corner_has_entered(const Vec2& before, const Vec2& corner, const Vec2& after, const Vec2& from,
                                      const Vec2& to);
// [collide.vertex_edge.entered.declared]

// [collide.vertex_edge.declared]
/// Where two overlapping polygons have entered each other, by following their boundaries; convex or not, with or
/// without holes. Normals point from A to B.
///
/// Every piece that the two have in common has a boundary that consists of chains of vertices of A inside B and of B
/// inside A, joined where edges cross. One corner inside, between two crossings with the same edge, is
/// `corner_has_entered`. Of the edges that bound the piece, the one over which the other's chain has entered the least
/// deep makes the contact, at the deepest vertex of that chain: along the edge's own normal, which its turning tells,
/// and at the middle of the common stretch where an edge of the chain is parallel. Where two edges of the piece cross
/// but no vertex is inside (two bars laid crosswise), the depth is the width of the piece, and the contact lies at its
/// middle.
///
/// One contact per piece, in the order of A's edges. None where the polygons are apart or one holds the other without
/// a crossing. Which side of an edge a vertex is on is decided exactly, from vertices rounded once; where one lies
/// exactly on the other's line, as if A were pushed towards B's origin by less than any number. So two convex polygons
/// that merely touch make a contact of depth zero. `Contact::feature` is as in `make_manifold`.
///
/// Time: the product of the two numbers of edges.
[[nodiscard]] std::vector<Contact> entered_contacts(const Polygon& a, const Pose& world_from_a, const Polygon& b,
                                                    const Pose& world_from_b);
// [collide.vertex_edge.declared]

} // namespace flying
