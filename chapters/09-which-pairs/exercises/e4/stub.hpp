#pragma once

#include <utility>
#include <vector>

#include "math/vec2.hpp"

using flying::Vec2;

/// Pairs (i, k), i < k, with a distance of at most `reach`, in order.
inline std::vector<std::pair<int, int>> near_pairs(const std::vector<Vec2>& points, double reach)
{
    (void)points, (void)reach;
    return {}; // your code here
}
