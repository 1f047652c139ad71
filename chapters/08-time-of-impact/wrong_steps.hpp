#pragma once

#include "collide/separation.hpp"
#include "geometry/polygon.hpp"
#include "toi/predict.hpp"

namespace flying {

/// A wall that stands, and a disc that flies at it.  [m]
inline constexpr double k_wall_thickness = 0.02;
inline constexpr double k_disc_radius = 0.05;

/// The wall as a polygon, upright in the origin.
inline Polygon thin_wall()
{
    const double x = 0.5 * k_wall_thickness;
    return Polygon({{{-x, -1.0}, {x, -1.0}, {x, 1.0}, {-x, 1.0}}});
}

/// A disc that flies to the right.  x  where it starts [m]; speed  [m/s]
inline Flyer thrown(double x, double speed)
{
    Flyer flyer;
    flyer.state.position = {x, 0.0};
    flyer.state.velocity = {speed, 0.0};
    return flyer;
}


/// WRONG, and it looks right: moves the disc step by step, and looks after each whether it
/// is in the wall. When it first is, or never.  flyer  the disc; step, until  [s]
inline double first_overlap(const Flyer& flyer, double step, double until)
{
    const Shape disc = Disc{k_disc_radius};
    const Shape wall = thin_wall();
    for (int k = 0; k * step <= until; ++k) {
        const Pose pose = pose_of(state_at(flyer, k * step));
        if (separation(disc, pose, wall, Pose{}) < 0.0) return k * step;
    }
    return k_never;
}


} // namespace flying
