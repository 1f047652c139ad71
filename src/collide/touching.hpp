#pragma once

#include <vector>

#include "collide/feature.hpp"
#include "geometry/shape.hpp"
#include "math/rotation.hpp"

namespace flying {

/// One point at which two bodies touch, as an impact needs it.
struct Touch
{
    Vec2 r_a = Vec2::Zero();    ///< from A's position to the point [m]
    Vec2 r_b = Vec2::Zero();    ///< from B's position to the point [m]
    Vec2 normal = Vec2::Zero(); ///< unit vector from A to B
    double separation = 0.0;    ///< gap along the normal, negative where they overlap [m]
    Feature feature;
};

/// Every point at which two bodies touch.
///
/// a, b                        discs, polygons of any kind, half-planes; not two half-planes
/// world_from_a, world_from_b  where they are
/// tolerance                   gap, of either sign, that still counts as touching; small against every edge [m]
/// touches                     filled, in the order of the features; emptied first
///
/// A vertex on an edge takes the edge's normal. A vertex on a vertex takes the middle of all directions in which the two
/// could part (the cone of separating normals): two parallel faces whose ends meet get the face's normal, two squares
/// that meet corner to corner along their diagonals the diagonal.
void find_touches(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b, double tolerance,
                  std::vector<Touch>& touches);

} // namespace flying
