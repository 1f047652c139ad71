#pragma once

/// The eccentricity of an ellipse on which a body needs the time t from the distance r_1 to r_2, on its way out.
///
/// mu  strength of the centre [m^3/s^2]; a  half of the long axis [m]; r_1 < r_2  below 2 a [m]; t  [s]
inline double eccentricity_from(double mu, double a, double r_1, double r_2, double t)
{
    (void)mu, (void)a, (void)r_1, (void)r_2, (void)t;
    return 0.0; // your code here
}
