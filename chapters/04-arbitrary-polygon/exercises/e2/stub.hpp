#pragma once

#include <span>

#include "math/vec2.hpp"

struct WireMoments
{
    double mass = 0.0;                            ///< [kg]
    flying::Vec2 centroid = flying::Vec2::Zero(); ///< [m]
    double moment_of_inertia = 0.0;               ///< about the centroid [kg m^2]
};

/// A closed wire along the edges of a ring.
/// ring  its corners [m]; mass_per_length [kg/m]
inline WireMoments wire_moments(std::span<const flying::Vec2> ring, double mass_per_length)
{
    (void)ring, (void)mass_per_length;
    return {}; // your code here
}
