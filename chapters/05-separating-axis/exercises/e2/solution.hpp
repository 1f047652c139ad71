#pragma once

#include "collide/separating_axis.hpp"

/// Shortest move of B that parts it from A; zero where they don't overlap.  [m], in the world
inline flying::Vec2 way_out(const flying::Polygon& a, const flying::Pose& pose_a, const flying::Polygon& b,
                            const flying::Pose& pose_b)
{
    const flying::Axis axis = flying::greatest_separation(a, b, flying::relative_pose(pose_a, pose_b));
    if (axis.separation >= 0.0) return flying::Vec2::Zero();

    // B's normal looks at A: against it, B goes away
    const bool is_of_a = axis.owner == flying::Owner::a;
    const flying::Vec2 outwards = is_of_a ? flying::Vec2(pose_a.rotation * a.edges()[axis.edge].normal)
                                          : flying::Vec2(-(pose_b.rotation * b.edges()[axis.edge].normal));
    return -axis.separation * outwards;
}
