#pragma once

#include "collide/contact.hpp"
#include "collide/separating_axis.hpp"
#include "geometry/shape.hpp"
#include "math/rotation.hpp"

namespace flying {

/// The points at which two convex shapes touch or overlap, with the normal from A to B.
///
/// Two polygons: the axis of greatest separation chooses a reference edge; the edge of the other that faces it most is
/// clipped to the reference edge's width, and what remains of it makes one or two contacts. Their separations are
/// measured along the reference edge's normal. Everything else makes one contact, a polygon on a half-plane up to two:
/// its lowest vertices.
///
/// a, b                        discs, convex polygons, half-planes; not two half-planes. Polygons with corners only: what
///                             lies over a vertex in the middle of a straight side would touch one half of it. The parts
///                             of a `CollisionShape` are such polygons
/// world_from_a, world_from_b  where they are
/// margin                      points further apart than this make no contact, >= 0 [m]
///
/// Contact::feature holds, from its lowest bit: whether the vertex is B's, the vertex (15 bits), the edge (16 bits).
/// Numbers are distinct as long as polygons have fewer than 32768 vertices. 0 where smooth surfaces meet.
[[nodiscard]] Manifold make_manifold(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                                     double margin);

/// The same of two convex polygons whose axis of greatest separation is known already, that of the `greater_of` their
/// `best_edges`.
///
/// a_from_b  where B lies as A sees it
[[nodiscard]] Manifold make_manifold(const Polygon& a, const Pose& world_from_a, const Polygon& b,
                                     const Pose& world_from_b, const Pose& a_from_b, const Axis& axis, double margin);

} // namespace flying
