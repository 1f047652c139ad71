#pragma once

#include <initializer_list>

#include "geometry/aabb.hpp"

namespace flying {

/// The point lies in the box.
inline bool holds(const Aabb& box, const Vec2& p)
{
    return box.min.x() <= p.x() && p.x() <= box.max.x() && box.min.y() <= p.y() && p.y() <= box.max.y();
}


/// Wrong: boxes overlap where one has a corner in the other.
inline bool wrong_overlap(const Aabb& a, const Aabb& b)
{
    const auto has_corner_in = [](const Aabb& inner, const Aabb& outer) {
        for (const double x : {inner.min.x(), inner.max.x()}) {
            for (const double y : {inner.min.y(), inner.max.y()}) {
                if (holds(outer, Vec2(x, y))) return true;
            }
        }
        return false;
    };
    return has_corner_in(a, b) || has_corner_in(b, a);
}


} // namespace flying
