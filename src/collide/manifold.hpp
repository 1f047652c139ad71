#pragma once

#include <cstdint>

#include "collide/contact.hpp"
#include "collide/separating_axis.hpp"
#include "geometry/shape.hpp"
#include "math/rotation.hpp"

namespace flying {

/// A vertex of one body on an edge of the other.
struct VertexOnEdge
{
    Owner of_vertex = Owner::a; ///< whose vertex it is
    int vertex = 0;
    int edge = 0; ///< of the other body
};

/// Such a pair as one number, from its lowest bit: whether the vertex is B's, the vertex (15 bits), the edge (14 bits).
/// The two bits that are left tell pairs of other kinds from these. Numbers are distinct as long as polygons have fewer
/// than 16384 vertices.
[[nodiscard]] inline std::uint32_t feature_number(const VertexOnEdge& pair)
{
    const std::uint32_t is_of_b = pair.of_vertex == Owner::b ? 1u : 0u;
    return is_of_b | (static_cast<std::uint32_t>(pair.vertex) & 0x7fffu) << 1 |
           static_cast<std::uint32_t>(pair.edge) << 16;
}

/// The pair that has a number, whatever its kind.
[[nodiscard]] inline VertexOnEdge vertex_on_edge(std::uint32_t feature)
{
    return {(feature & 1u) != 0u ? Owner::b : Owner::a, static_cast<int>(feature >> 1 & 0x7fffu),
            static_cast<int>(feature >> 16 & 0x3fffu)};
}

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
/// Contact::feature is the `feature_number` of the vertex and the edge that meet; 0 where smooth surfaces do.
[[nodiscard]] Manifold make_manifold(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                                     double margin);

/// The same of two convex polygons whose axis of greatest separation is known already, that of the `greater_of` their
/// `best_edges`.
///
/// a_from_b  where B lies as A sees it
[[nodiscard]] Manifold make_manifold(const Polygon& a, const Pose& world_from_a, const Polygon& b,
                                     const Pose& world_from_b, const Pose& a_from_b, const Axis& axis, double margin);

} // namespace flying
