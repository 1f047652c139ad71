#pragma once

#include <span>
#include <vector>

#include "math/vec2.hpp"

namespace flying {

/// One side of a polygon, from a vertex to the next. The inside lies to the left.
struct Edge
{
    int from = 0;                ///< index of the first vertex; the edge has the same index
    int to = 0;                  ///< index of the second vertex
    Vec2 tangent = Vec2::Zero(); ///< unit vector from the first to the second
    Vec2 normal = Vec2::Zero();  ///< unit vector, outwards
    double length = 0.0;         ///< [m]
};

/// A simple polygon, convex or not, with or without holes, in a frame of its own.
///
/// The outer ring turns counter-clockwise, holes turn clockwise, so that the inside always
/// lies to the left of an edge. All rings stand one after another in `vertices()`; edge k
/// starts at vertex k. Whether rings are fit to be a polygon is asked by `make_polygon`
/// (geometry/make_polygon.hpp), the one checked door.
class Polygon
{
public:
    /// rings  the outer ring first, each with three vertices or more, simple, disjoint,
    /// turning as said above [m]
    explicit Polygon(const std::vector<std::vector<Vec2>>& rings);

    /// Of all rings, one ring after the other.  [m]
    [[nodiscard]] std::span<const Vec2> vertices() const { return vertices_; }
    /// As many as vertices: edge k leads from vertex k to the next of its ring.
    [[nodiscard]] std::span<const Edge> edges() const { return edges_; }

    /// Index of the first vertex of each ring, and the number of all vertices at the end:
    /// ring k holds the vertices ring_starts()[k] ... ring_starts()[k + 1] - 1.
    [[nodiscard]] std::span<const int> ring_starts() const { return ring_starts_; }

    /// The edge that ends where edge `vertex` starts.
    [[nodiscard]] int previous(int vertex) const { return previous_[vertex]; }

    /// The inside angle at the vertex is over half a turn: no other body's edge can reach
    /// it first.
    [[nodiscard]] bool is_reflex(int vertex) const { return is_reflex_[vertex] != 0; }

    /// No reflex vertex and no hole.
    [[nodiscard]] bool is_convex() const { return is_convex_; }

    /// Greatest distance of a vertex from the origin.  [m]
    [[nodiscard]] double radius() const { return radius_; }

    /// The same polygon, moved by `offset`.
    [[nodiscard]] Polygon moved_by(const Vec2& offset) const;

private:
    std::vector<Vec2> vertices_;
    std::vector<Edge> edges_;
    std::vector<int> ring_starts_;
    std::vector<int> previous_;
    std::vector<char> is_reflex_;
    bool is_convex_ = true;
    double radius_ = 0.0;
};

} // namespace flying
