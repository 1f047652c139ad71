#pragma once

#include <cmath>
#include <numbers>

#include "mass/mass_properties.hpp"
#include "math/sine_cosine.hpp"

namespace flying {


/// Mass and moment of inertia of n triangles on sides of length l.
[[nodiscard]] inline MassProperties polygon_by_side(int sides, double l, double cot,
                                                    double density)
{
    const double m = density * sides * (l * l) * cot / 4.0;
    return {m, m * (l * l) / 24.0 * (1.0 + 3.0 * cot * cot)};
}



/// A regular polygon through the length of its side and the cotangent.
[[nodiscard]] inline MassProperties polygon_by_cotangent(int sides, double radius,
                                                         double density)
{
    const SineCosine half = sine_cosine(std::numbers::pi / sides);
    const double l = 2.0 * radius * half.sine;
    return polygon_by_side(sides, l, half.cosine / half.sine, density);
}



/// WRONG for many sides, and it looks right: the side by the law of cosines,
/// the height of the triangle by Pythagoras.
[[nodiscard]] inline MassProperties wrong_polygon_mass(int sides, double radius,
                                                       double density)
{
    const double theta = 2.0 * std::numbers::pi / sides;
    const double l = radius * std::sqrt(2.0 - 2.0 * sine_cosine(theta).cosine);
    const double h = std::sqrt(radius * radius - l * l / 4.0);
    return polygon_by_side(sides, l, 2.0 * h / l, density);
}


} // namespace flying
