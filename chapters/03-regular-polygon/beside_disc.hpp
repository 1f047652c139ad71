#pragma once

#include <numbers>

#include "../02-rectangle/rectangle.hpp"
#include "regular_polygon.hpp"

namespace flying {


/// Moment of inertia of a regular polygon over that of the disc through its
/// vertices, of the same material.
[[nodiscard]] inline double beside_disc_of_same_radius(int sides)
{
    const MassProperties polygon = regular_polygon_mass(sides, 1.0, 1.0);
    return polygon.moment_of_inertia / disc_mass(1.0, 1.0).moment_of_inertia;
}



/// The same beside the disc that has the polygon's area, and so its mass.
[[nodiscard]] inline double beside_disc_of_same_area(int sides)
{
    const MassProperties polygon = regular_polygon_mass(sides, 1.0, 1.0);
    const double squared_radius = polygon.mass / std::numbers::pi;
    return polygon.moment_of_inertia / (0.5 * polygon.mass * squared_radius);
}


} // namespace flying
