#pragma once

namespace flying {


/// How far a body falls from rest in time t: g t^2 / 2.   [m]
/// g  acceleration of free fall  [m/s^2]
/// t  since it was let go        [s]
[[nodiscard]] inline double fall_distance(double g, double t)
{
    return 0.5 * g * t * t;
}



/// The same by equal steps: in each, the body moves at the speed of the step's start.   [m]
/// steps  1 or more
[[nodiscard]] inline double fall_by_steps(double g, double t, int steps)
{
    const double dt = t / steps;
    double v = 0.0;
    double s = 0.0;
    for (int k = 0; k < steps; ++k) {
        // Move first, then gain speed: the order makes the error
        s += v * dt;
        v += g * dt;
    }
    return s;
}


} // namespace flying
