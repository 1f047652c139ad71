#pragma once

/// Ways to let a body lie on a floor at x = 0 that look right.
namespace flying::test {


/// Height of the lowest point, and velocity upwards.
struct Lying
{
    double x = 0.0; ///< [m]
    double v = 0.0; ///< [m/s]
};



/// Move, then look; and where it has come too far, turn it round.
inline void move_then_bounce(Lying& body, double g, double dt, double e)
{
    body.v -= g * dt;
    body.x += body.v * dt;
    if (body.x < 0.0 && body.v < 0.0) body.v = -e * body.v;
}



/// Move, then look; and where it has come too far, push it out within one step.
inline void push_by_overlap(Lying& body, double g, double dt)
{
    body.v -= g * dt;
    body.x += body.v * dt;
    if (body.x < 0.0) body.v += -body.x / dt;
}


} // namespace flying::test
