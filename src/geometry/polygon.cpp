#include "geometry/polygon.hpp"

#include <algorithm>

namespace flying {

Polygon::Polygon(const std::vector<std::vector<Vec2>>& rings)
{
    ring_starts_.push_back(0);
    for (const std::vector<Vec2>& ring : rings) {
        const int first = static_cast<int>(vertices_.size());
        const int count = static_cast<int>(ring.size());

        // Chain the vertices of the ring, the last to the first
        for (int k = 0; k < count; ++k) {
            const Vec2& a = ring[k];
            const Vec2& b = ring[(k + 1) % count];
            const double length = (b - a).norm();
            const Vec2 tangent = (b - a) / length;
            vertices_.push_back(a);
            edges_.push_back({first + k, first + (k + 1) % count, tangent,
                              Vec2(tangent.y(), -tangent.x()), length});
            previous_.push_back(first + (k + count - 1) % count);
            radius_ = std::max(radius_, a.norm());
        }
        ring_starts_.push_back(static_cast<int>(vertices_.size()));
    }

    // Mark the vertices at which the boundary turns right
    is_convex_ = rings.size() == 1;
    for (std::size_t k = 0; k < vertices_.size(); ++k) {
        const bool reflex = cross(edges_[previous_[k]].tangent, edges_[k].tangent) < 0.0;
        is_reflex_.push_back(reflex ? 1 : 0);
        is_convex_ = is_convex_ && !reflex;
    }
}

Polygon Polygon::moved_by(const Vec2& offset) const
{
    std::vector<std::vector<Vec2>> rings;
    for (std::size_t k = 0; k + 1 < ring_starts_.size(); ++k) {
        std::vector<Vec2>& ring = rings.emplace_back();
        for (int v = ring_starts_[k]; v < ring_starts_[k + 1]; ++v) ring.push_back(vertices_[v] + offset);
    }
    return Polygon(rings);
}

} // namespace flying
