#pragma once

#include <cmath>

#include "geometry/shape.hpp"
#include "toi/prediction.hpp"

namespace flying {

// A search for the next touch looks at one window of time after the other.

/// How far the bodies' points may travel in one window, in radii of the smaller body: long windows make bounds on the
/// bend loose, short ones are looked at more often.
inline constexpr double k_window_travel = 1.0;

/// Speed of a body's farthest vertex about its centre; none for discs, which look the same from every side.  [m/s]
[[nodiscard]] inline double tip_speed(const Disc&, const Flyer&) { return 0.0; }
[[nodiscard]] inline double tip_speed(const HalfPlane&, const Flyer&) { return 0.0; }
[[nodiscard]] inline double tip_speed(const Polygon& polygon, const Flyer& flyer)
{
    return std::abs(flyer.state.spin) * polygon.radius();
}

} // namespace flying
