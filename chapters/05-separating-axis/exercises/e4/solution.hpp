#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "math/vec2.hpp"

using flying::Vec2;

inline double to_segment(const Vec2& p, const Vec2& from, const Vec2& to)
{
    const Vec2 along = to - from;
    const double share = std::clamp(along.dot(p - from) / along.squaredNorm(), 0.0, 1.0);
    return (p - from - share * along).norm();
}

/// Some edge of `owner` has all of `other` beyond it.
inline bool parts(const std::vector<Vec2>& owner, const std::vector<Vec2>& other)
{
    for (std::size_t k = 0; k < owner.size(); ++k) {
        const Vec2 along = owner[(k + 1) % owner.size()] - owner[k];
        const Vec2 out(along.y(), -along.x());
        const auto beyond = [&](const Vec2& p) { return out.dot(p - owner[k]) > 0.0; };
        if (std::all_of(other.begin(), other.end(), beyond)) return true;
    }
    return false;
}

/// Distance of two convex polygons, counter-clockwise; 0 where they touch or overlap.   [m]
inline double distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b)
{
    if (!parts(a, b) && !parts(b, a)) return 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; k < b.size(); ++k) {
            least = std::min(least, to_segment(a[i], b[k], b[(k + 1) % b.size()]));
            least = std::min(least, to_segment(b[k], a[i], a[(i + 1) % a.size()]));
        }
    }
    return least;
}
