#pragma once

#include <cmath>
#include <limits>

#include "geometry/polygon.hpp"
#include "math/rotation.hpp"

namespace flying {


/// Wrong: the normal of that edge of A which a corner of B lies nearest to, in the world.
inline Vec2 wrong_normal(const Polygon& a, const Pose& pose_a, const Polygon& b,
                         const Pose& pose_b)
{
    double nearest = std::numeric_limits<double>::infinity();
    Vec2 normal = Vec2::Zero();
    for (const Edge& edge : a.edges()) {
        const Vec2 n = pose_a.rotation * edge.normal;
        const Vec2 t = pose_a.rotation * edge.tangent;
        for (const Vec2& vertex : b.vertices()) {
            const Vec2 from_edge = pose_b * vertex - pose_a * a.vertices()[edge.from];
            const double along = t.dot(from_edge);
            const double distance = std::abs(n.dot(from_edge));
            if (along < 0.0 || along > edge.length || distance >= nearest) continue;
            nearest = distance;
            normal = n;
        }
    }
    return normal;
}


} // namespace flying
