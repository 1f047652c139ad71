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
    // All places are measured from a corner of the ring's own
    const flying::Vec2 corner = ring.front();
    double mass = 0.0;
    flying::Vec2 first = flying::Vec2::Zero();
    double second = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const flying::Vec2 a = ring[k] - corner;
        const flying::Vec2 b = ring[(k + 1) % ring.size()] - corner;
        const flying::Vec2 middle = 0.5 * (a + b);
        const double m = mass_per_length * (b - a).norm();
        mass += m;
        first += m * middle;
        second += m * ((b - a).squaredNorm() / 12.0 + middle.squaredNorm());
    }

    // Back to the centroid
    const flying::Vec2 centroid = first / mass;
    return {mass, corner + centroid, second - mass * centroid.squaredNorm()};
}
