#pragma once

#include <cmath>

#include "math/vec2.hpp"
#include "steppers.hpp"

/// Motion round a body so heavy that it stays where it is: at the origin.
namespace flying::steps {


/// Newton's pull of a centre at the origin.
struct CentralPull
{
    double mu; ///< strength [m^3/s^2]

    /// Acceleration at x.   [m/s^2]
    [[nodiscard]] Vec2 operator()(const Vec2& x) const
    {
        const double r = x.norm();
        return (-mu / (r * r * r)) * x;
    }
};



/// Energy for each kilogram: negative where the body can't get away.   [J/kg]
[[nodiscard]] inline double energy(const Moving& b, double mu)
{
    return 0.5 * b.v.squaredNorm() - mu / b.x.norm();
}



/// Angular momentum for each kilogram.   [m^2/s]
[[nodiscard]] inline double angular_momentum(const Moving& b)
{
    return cross(b.x, b.v);
}

/// The eccentricity vector: from the centre towards the nearest point of the orbit.   [1]
[[nodiscard]] inline Vec2 eccentricity(const Moving& b, double mu)
{
    const double l = angular_momentum(b);
    return -(l / mu) * perp(b.v) - b.x / b.x.norm();
}


} // namespace flying::steps
