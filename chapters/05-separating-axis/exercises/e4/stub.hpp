#pragma once

#include <vector>

#include "math/vec2.hpp"

using flying::Vec2;

/// Distance of two convex polygons, counter-clockwise; 0 where they touch or overlap.   [m]
inline double distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b)
{
    return (a[0] - b[0]).norm(); // your code here
}
