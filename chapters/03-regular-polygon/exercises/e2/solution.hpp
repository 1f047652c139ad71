#pragma once

#include <numbers>

#include "02-rectangle/rectangle.hpp"
#include "03-regular-polygon/regular_polygon.hpp"
#include "math/sine_cosine.hpp"

/// A nut about its centre.
/// sides  even, 4 or more; wrench  distance of opposite sides [m]; hole  radius of the round hole [m];
/// density [kg/m^2]
inline flying::MassProperties nut_mass(int sides, double wrench, double hole, double density)
{
    // The wrench measures twice the distance of a side from the centre
    const double radius = 0.5 * wrench / flying::sine_cosine(std::numbers::pi / sides).cosine;
    const flying::MassProperties full = flying::regular_polygon_mass(sides, radius, density);
    const flying::MassProperties taken = flying::disc_mass(hole, density);
    return {full.mass - taken.mass, full.moment_of_inertia - taken.moment_of_inertia};
}
