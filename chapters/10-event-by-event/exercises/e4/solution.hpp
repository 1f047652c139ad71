#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "toi/discs.hpp"

/// When a disc touches an image of another that is at rest at the origin.  [s] from now
inline double meet_images(double x, double y, double vx, double vy, double reach, double length, double until)
{
    const double speed = std::sqrt(vx * vx + vy * vy);
    if (!(speed > 0.0)) return std::numeric_limits<double>::infinity();

    // Pieces of half a room: what can be touched in one lies within a room of its middle
    const double piece = 0.5 * length / speed;
    for (int count = 0; count * piece < until; ++count) {
        const double begin = count * piece;
        const double middle = begin + 0.5 * piece;
        const double column = std::round((x + middle * vx) / length);
        const double row = std::round((y + middle * vy) / length);
        double first = std::numeric_limits<double>::infinity();
        for (int i = -1; i <= 1; ++i) {
            for (int k = -1; k <= 1; ++k) {
                const flying::Vec2 offset(x - (column + i) * length, y - (row + k) * length);
                const flying::Vec2 there = offset + begin * flying::Vec2(vx, vy);
                first = std::min(first, begin + flying::time_to_meet(there, {vx, vy}, reach));
            }
        }
        if (first < begin + piece) return first < until ? first : std::numeric_limits<double>::infinity();
    }
    return std::numeric_limits<double>::infinity();
}
