#pragma once

#include <algorithm>

/// A disc of uniform density.
struct Disc
{
    double mass;   ///< [kg]
    double radius; ///< [m]
    double v_x;    ///< [m/s]
    double v_y;    ///< up [m/s]
    double spin;   ///< [rad/s]
};

/// The disc after it met a level floor. e  restitution; mu  friction
inline Disc bounce(Disc disc, double e, double mu)
{
    // Leave a rising disc alone
    if (!(disc.v_y < 0.0)) return disc;

    // Find both impulses: the normal one by Newton's law, the tangential one by what the cone leaves of it
    const double j = -(1.0 + e) * disc.mass * disc.v_y;
    const double slip = disc.v_x + disc.spin * disc.radius;
    const double q = std::clamp(-slip * disc.mass / 3.0, -mu * j, mu * j);

    disc.v_x += q / disc.mass;
    disc.v_y += j / disc.mass;
    disc.spin += 2.0 * q / (disc.mass * disc.radius);
    return disc;
}
