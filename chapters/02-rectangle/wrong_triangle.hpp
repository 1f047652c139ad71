#pragma once

#include "mass/mass_properties.hpp"

namespace flying {


/// Right-angled triangle of two equal legs, about its centre of mass: I = m L^2 / 9.
inline MassProperties half_square_mass(double leg, double density)
{
    const double m = density * (0.5 * leg * leg);
    return {m, m * leg * leg / 9.0};
}



/// WRONG, and it looks right: many a table has b h^3 / 36 as a triangle's
/// moment of inertia.
inline MassProperties wrong_half_square_mass(double leg, double density)
{
    const double b = leg;
    const double h = leg;
    const double m = density * (0.5 * b * h);
    return {m, m * (b * h * h * h) / 36.0};
}


} // namespace flying
