#pragma once

/// How long after its nearest point a body on an ellipse is first at the distance r.   [s]
///
/// mu  strength of the centre [m^3/s^2]; a  half of the long axis [m]; ecc  above 0, below 1
/// r   from a (1 - ecc) to a (1 + ecc) [m]
inline double time_at(double mu, double a, double ecc, double r)
{
    (void)mu, (void)a, (void)ecc, (void)r;
    return 0.0; // your code here
}
