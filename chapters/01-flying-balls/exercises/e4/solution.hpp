#pragma once

#include <cmath>

/// Height above the floor at the time t.   [m]
/// y, v  height and velocity at the start, y >= 0  [m, m/s]; g  pull downwards, positive
/// [m/s^2]
inline double height_after(double y, double v, double g, double t)
{
    // Energy gives the speed at the floor; a hop at that speed is the period
    const double speed = std::sqrt(v * v + 2.0 * g * y);
    if (speed == 0.0) return 0.0;
    const double period = 2.0 * speed / g;

    // Since it left the floor it has been going for (speed - v) / g; whole hops don't count
    const double since = std::fmod((speed - v) / g + t, period);
    return since * (speed - 0.5 * g * since);
}
