#pragma once

#include <vector>

#include "math/orientation.hpp"

using flying::Vec2;

/// No two edges share a point, except neighbours at their common corner.
inline bool is_simple(const std::vector<Vec2>& ring)
{
    return ring.size() >= 3; // your code here
}
