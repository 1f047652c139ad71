#pragma once

#include <vector>

#include "math/vec2.hpp"

using flying::Vec2;

/// The part of a convex ring with n . x <= c.
inline std::vector<Vec2> cut(const std::vector<Vec2>& ring, const Vec2& n, double c)
{
    std::vector<Vec2> left;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2& p = ring[k];
        const Vec2& q = ring[(k + 1) % ring.size()];
        const double height_p = n.dot(p) - c;
        const double height_q = n.dot(q) - c;
        if (height_p <= 0.0) left.push_back(p);

        // A new corner only where the ends lie strictly on different sides: one on the line is there already
        if ((height_p < 0.0 && height_q > 0.0) || (height_p > 0.0 && height_q < 0.0))
            left.push_back(p + height_p / (height_p - height_q) * (q - p));
    }
    if (left.size() < 3) left.clear();
    return left;
}
