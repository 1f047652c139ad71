#pragma once

#include "collide/separating_axis.hpp"

/// Shortest move of B that parts it from A; zero where they don't overlap.  [m], in the world
inline flying::Vec2 way_out(const flying::Polygon& a, const flying::Pose& pose_a, const flying::Polygon& b,
                            const flying::Pose& pose_b)
{
    (void)a, (void)pose_a, (void)b, (void)pose_b;
    return flying::Vec2::Zero(); // your code here
}
