#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

/// How long until a centre at (x, y), which flies at (vx, vy), is `free` away from the origin. [s]
inline double time_to_rim(double x, double y, double vx, double vy, double free)
{
    const double speed2 = vx * vx + vy * vy;
    if (!(speed2 > 0.0)) return std::numeric_limits<double>::infinity();
    const double inward = -(x * vx + y * vy);
    const double miss = std::abs(x * vy - y * vx);
    const double span = std::sqrt(speed2) * free;
    const double root = std::sqrt(std::max(0.0, (span - miss) * (span + miss)));

    // The larger root: a sum on the way in, the other form on the way out
    if (inward >= 0.0) return (inward + root) / speed2;
    const double inside = (free - std::hypot(x, y)) * (free + std::hypot(x, y));
    return std::max(0.0, inside / (root - inward));
}
