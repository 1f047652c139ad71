#pragma once

#include <algorithm>
#include <vector>

#include "math/orientation.hpp"

using flying::Vec2;

/// p lies on the segment from a to b, ends included.
inline bool lies_on(const Vec2& p, const Vec2& a, const Vec2& b)
{
    return flying::orientation(a, b, p) == 0 && std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
           std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

inline bool share_a_point(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const bool c_and_d_apart = flying::orientation(a, b, c) * flying::orientation(a, b, d) < 0;
    const bool a_and_b_apart = flying::orientation(c, d, a) * flying::orientation(c, d, b) < 0;
    if (c_and_d_apart && a_and_b_apart) return true;
    return lies_on(c, a, b) || lies_on(d, a, b) || lies_on(a, c, d) || lies_on(b, c, d);
}

/// No two edges share a point, except neighbours at their common corner.
inline bool is_simple(const std::vector<Vec2>& ring)
{
    const std::size_t n = ring.size();
    if (n < 3) return false;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2& a = ring[i];
        const Vec2& b = ring[(i + 1) % n];

        // The next edge shares b, and nothing else
        const Vec2& after = ring[(i + 2) % n];
        if (a == b || lies_on(after, a, b) || lies_on(a, b, after)) return false;
        for (std::size_t k = i + 2; k < n; ++k) {
            if ((k + 1) % n == i) continue; // the edge before
            if (share_a_point(a, b, ring[k], ring[(k + 1) % n])) return false;
        }
    }
    return true;
}
