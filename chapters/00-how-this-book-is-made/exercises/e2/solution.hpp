#pragma once

/// How far a body falls from rest in time t, by equal steps, each at the speed of its middle.   [m]
inline double fall_by_middle(double g, double t, int steps)
{
    const double dt = t / steps;
    double v = 0.0;
    double s = 0.0;
    for (int k = 0; k < steps; ++k) {
        s += (v + 0.5 * g * dt) * dt;
        v += g * dt;
    }
    return s;
}
