#pragma once

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
    (void)e, (void)mu;
    return disc; // your code here
}
