#pragma once

#include "geometry/shape.hpp"
#include "math/rotation.hpp"

namespace flying {

/// Axis-aligned bounding box.
struct Aabb
{
    Vec2 min = Vec2::Zero(); ///< [m]
    Vec2 max = Vec2::Zero(); ///< [m]
};

/// The two boxes share a point.
[[nodiscard]] inline bool overlap(const Aabb& a, const Aabb& b)
{
    return a.min.x() <= b.max.x() && b.min.x() <= a.max.x() &&
           a.min.y() <= b.max.y() && b.min.y() <= a.max.y();
}

/// Smallest box that holds the shape at the pose; infinite in every direction for a half-plane.
[[nodiscard]] Aabb bounding_box(const Shape& shape, const Pose& world_from_body);

} // namespace flying
