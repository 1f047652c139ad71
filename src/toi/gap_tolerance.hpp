#pragma once

#include <algorithm>
#include <cmath>

#include "math/tolerance.hpp"
#include "math/vec2.hpp"

namespace flying {

/// What rounding leaves undecided about a pair in flight.
struct GapTolerance
{
    double touch = 0.0;    ///< gap of either sign that counts as touching [m]
    double noise = 0.0;    ///< gap that can't be told from zero: rounding of coordinates and times [m]
    double approach = 0.0; ///< approach slower than this is rounding [m/s]
};

/// smaller, larger  radii of the two bodies; equal where one of them is a half-plane [m]
/// reach            distance from the world's origin to where they might meet [m]
/// speed            bound on the speed of any point of either [m/s]
/// time             the moment [s]
[[nodiscard]] inline GapTolerance gap_tolerance(double smaller, double larger, double reach,
                                                double speed, double time)
{
    using namespace tolerance;
    const double of_places = k_coordinate_roundings * (reach + larger);
    const double noise = k_epsilon * (of_places + 2.0 * (speed * std::abs(time)));
    return {k_touch * smaller + noise, 0.25 * noise, k_approach * speed};
}

} // namespace flying
