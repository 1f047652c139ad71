#pragma once

#include <array>

#include "math/orientation.hpp"

/// The point lies strictly inside a triangle that turns counter-clockwise. Exact.
inline bool is_inside(const flying::Vec2& point, const std::array<flying::Vec2, 3>& triangle)
{
    // Left of all three edges; a turn of zero means on the edge's line
    for (std::size_t k = 0; k < 3; ++k) {
        if (flying::orientation(triangle[k], triangle[(k + 1) % 3], point) <= 0) return false;
    }
    return true;
}
