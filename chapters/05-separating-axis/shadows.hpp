#pragma once

#include <algorithm>
#include <numbers>
#include <vector>

#include "geometry/polygon.hpp"
#include "math/rotation.hpp"

namespace flying {


/// A rectangle about its centre. Edges: 0 below, 1 right, 2 above, 3 left.
/// width, height  [m]
inline Polygon box_of(double width, double height)
{
    const double x = 0.5 * width;
    const double y = 0.5 * height;
    return Polygon({{Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)}});
}

/// A pose at (x, y), turned by an angle.  [m], [rad]
inline Pose placed(double x, double y, double angle = 0.0)
{
    return {Vec2(x, y), Rotation::of(angle)};
}



/// A regular polygon about its centre, its first vertex to the right.
/// sides  three or more
/// radius of its corners [m]
inline Polygon regular(int sides, double radius)
{
    std::vector<Vec2> ring;
    for (int k = 0; k < sides; ++k) {
        const Rotation turn = Rotation::of(2.0 * std::numbers::pi * k / sides);
        ring.push_back(turn * Vec2(radius, 0.0));
    }
    return Polygon({ring});
}



/// Gap between the shadows on one direction: the least of B less the greatest of A.  [m]
inline double gap(const Polygon& a, const Pose& pose_a, const Polygon& b,
                  const Pose& pose_b, const Vec2& n)
{
    double reach_a = n.dot(pose_a * a.vertices()[0]);
    for (const Vec2& p : a.vertices()) reach_a = std::max(reach_a, n.dot(pose_a * p));

    double start_b = n.dot(pose_b * b.vertices()[0]);
    for (const Vec2& q : b.vertices()) start_b = std::min(start_b, n.dot(pose_b * q));
    return start_b - reach_a;
}


} // namespace flying
