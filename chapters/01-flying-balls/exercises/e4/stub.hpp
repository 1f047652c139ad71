#pragma once

/// Height above the floor at the time t.   [m]
/// y, v  height and velocity at the start, y >= 0  [m, m/s]; g  pull downwards, positive
/// [m/s^2]
inline double height_after(double y, double v, double g, double t)
{
    return y + v * t - 0.5 * g * t * t; // your code here
}
