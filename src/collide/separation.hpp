#pragma once

#include <vector>

#include "geometry/shape.hpp"
#include "math/rotation.hpp"

namespace flying {

/// Signed distance between two shapes: the length of the shortest way between them where they are apart (to rounding),
/// and where they overlap minus the depth of the overlap.
///
/// Depth of convex shapes: length of the shortest push that parts them. Depth of shapes that are not convex: the
/// greatest depth among pairs of their convex parts; positive whenever the interiors meet, one shape within another
/// included, and never above the push that parts them. A hole of one shape may hold another without overlap. Two
/// half-planes: +infinity.
///
/// Cuts shapes that are not convex into parts each time it is called; `CollisionShape` does that once.
///
/// a, b                        discs, polygons of any kind, half-planes (whose pose plays no part)
/// world_from_a, world_from_b  where they are
[[nodiscard]] double separation(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b);

/// A convex part of a shape, in the shape's frame, and a circle that holds it.
struct ConvexPart
{
    Shape shape;
    Vec2 centre = Vec2::Zero(); ///< of the circle; without meaning for a half-plane [m]
    double radius = 0.0;        ///< of the circle; infinite for a half-plane [m]
};

/// A shape as the union of convex parts, cut once and kept as long as the shape.
struct CollisionShape
{
    std::vector<ConvexPart> parts;
};

/// The parts of a shape: one for all that is convex. Parts have corners only: vertices at which a boundary goes straight
/// on, to rounding, are left out.
[[nodiscard]] CollisionShape make_collision_shape(const Shape& shape);

/// Signed distance between two shapes, as above, from parts that are cut already. Allocates nothing.
[[nodiscard]] double separation(const CollisionShape& a, const Pose& world_from_a, const CollisionShape& b,
                                const Pose& world_from_b);

} // namespace flying
