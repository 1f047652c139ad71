#pragma once

#include <cmath>

#include "geometry/polygon.hpp"
#include "motion/flight.hpp"
#include "toi/predict.hpp"
#include "toi/safe_march.hpp"

namespace flying {

/// Half the length and half the thickness of the bar.  [m]
inline constexpr double k_half_length = 1.0;
inline constexpr double k_half_thickness = 0.01;

/// The floor: all that lies at y <= 0.
inline const HalfPlane k_floor{{0.0, 1.0}, 0.0};


/// From the bar's middle to its corner [m], and how far below the bar's axis that one lies [rad].
inline const double k_arm = std::hypot(k_half_length, k_half_thickness);
inline const double k_lean = std::atan2(k_half_thickness, k_half_length);

/// When a bar strikes the floor that turns in place: the closed form.
/// y  of its middle, less than its arm [m]; spin  clockwise [rad/s]
inline double bar_strikes(double y, double spin)
{
    return (std::asin(y / k_arm) - k_lean) / spin;
}


/// The bar as a polygon.
inline Polygon bar()
{
    const double x = k_half_length;
    const double y = k_half_thickness;
    return Polygon({{{-x, -y}, {x, -y}, {x, y}, {-x, y}}});
}

/// The bar's flight, which starts level.
/// y  of its middle [m]; spin  clockwise [rad/s]
inline Flyer turning_bar(double y, double spin)
{
    Flyer flyer;
    flyer.state.position = {0.0, y};
    flyer.state.spin = -spin;
    return flyer;
}


/// Height of the bar's lower right corner over the floor, and how fast it changes.
inline EdgeReading read_corner(double y, double spin, double time)
{
    const Vec2 arm = Rotation::of(-spin * time) * Vec2(k_half_length, -k_half_thickness);
    return {y + arm.y(), -spin * arm.x(), 0.0, 0.0};
}


/// What bounds the search. looseness  by how much the bound is larger than need be
inline MarchBounds bar_bounds(double y, double spin, double looseness)
{
    const double bend = looseness * spin * spin * k_arm * (1.0 + tolerance::k_bend_margin);
    return {bend, k_never, k_never, gap_tolerance(k_arm, k_arm, y, spin * k_arm, 10.0 / spin)};
}

} // namespace flying
