#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "discs.hpp"
#include "math/sine_cosine.hpp"

namespace flying {

/// Galperin's billiard: a wall on the left, a light ball of 1 kg at rest, a heavy one that
/// comes in at 1 m/s. The room has no other end.   ratio  of the two masses
inline discs::Room billiard_room(double ratio)
{
    return {{{1.0, 0.0, 0.0, 0.0, 0.25, 1.0}, {2.5, 0.0, -1.0, 0.0, 0.5, ratio}},
            discs::k_never,
            discs::k_never};
}

/// Half of the angle by which two impacts turn the point.  [rad]
inline double billiard_angle(double ratio)
{
    return std::atan(std::sqrt(1.0 / ratio));
}

/// How many n >= 1 have n theta < pi.
inline long whole_steps_below_pi(double theta)
{
    return static_cast<long>(std::ceil(std::numbers::pi / theta)) - 1;
}

/// Velocities in the end, by the circle. Both balls then go to the right.
struct BilliardSpeeds
{
    double light = 0.0; ///< [m/s]
    double heavy = 0.0;
};

inline BilliardSpeeds billiard_speeds_after(double ratio)
{
    const double theta = billiard_angle(ratio);
    const long n = whole_steps_below_pi(theta);
    const double turned = static_cast<double>(n % 2 == 0 ? n : n + 1) * theta;
    return {std::sqrt(ratio) * std::abs(std::sin(turned)), -std::cos(turned)};
}

/// Where the centres of the two balls are.  [m]
struct BilliardPlaces
{
    double light = 0.0;
    double heavy = 0.0;
};

/// The billiard's closed form at any moment: one straight line, folded into the
/// wedge.
inline BilliardPlaces billiard_places(double ratio, double time)
{
    // Free room of each ball, in lengths whose squares are weighed by the masses
    const double root = std::sqrt(ratio);
    const double x = root * (1.5 - time);
    const double y = 0.75;
    const double radius = std::sqrt(x * x + y * y);

    // Fold the angle into the wedge, like a strip of paper
    const double theta = billiard_angle(ratio);
    const double turn = std::fmod(std::atan2(y, x), 2.0 * theta);
    const SineCosine at = sine_cosine(turn <= theta ? turn : 2.0 * theta - turn);
    return {radius * at.sine + 0.25, radius * at.cosine / root + 1.0};
}

} // namespace flying
