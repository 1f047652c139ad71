#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/vec2.hpp"

using flying::Vec2;

/// When a point at x, flying at v, first comes within `radius` of the origin.
inline double to_point(const Vec2& x, const Vec2& v, double radius)
{
    const double approach = -x.dot(v);
    const double discriminant = approach * approach - v.squaredNorm() * (x.squaredNorm() - radius * radius);
    if (!(approach > 0.0) || discriminant < 0.0) return std::numeric_limits<double>::infinity();
    return (x.squaredNorm() - radius * radius) / (approach + std::sqrt(discriminant));
}

/// When the disc first touches the segment, or infinity.   [s]
inline double first_touch(const Vec2& x, const Vec2& v, double radius, const Vec2& p, const Vec2& q)
{
    // The ends
    double first = std::min(to_point(x - p, v, radius), to_point(x - q, v, radius));

    // The side that the disc is on, moved out by the radius
    const Vec2 along = (q - p).normalized();
    Vec2 normal(along.y(), -along.x());
    if (normal.dot(x - p) < 0.0) normal = -normal;
    const double height = normal.dot(x - p) - radius;
    const double sinks = -normal.dot(v);
    if (height >= 0.0 && sinks > 0.0) {
        const double time = height / sinks;
        const double place = along.dot(x + time * v - p);
        if (place >= 0.0 && place <= (q - p).norm()) first = std::min(first, time);
    }
    return first;
}
