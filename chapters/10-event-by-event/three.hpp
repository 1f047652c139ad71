#pragma once

#include <cmath>
#include <utility>

#include "balls.hpp"

namespace flying {

/// Three equal balls in a row, the first comes in at 1 m/s.  e  restitution
inline EventEngine three_in_a_row(double e)
{
    std::vector<EventBody> bodies;
    bodies.push_back(ball(0.5, 1.0, {-2.0, 0.0}, {1.0, 0.0}, e));
    bodies.push_back(ball(0.5, 1.0, {0.0, 0.0}, {0.0, 0.0}, e));
    bodies.push_back(ball(0.5, 1.0, {2.0, 0.0}, {0.0, 0.0}, e));
    return EventEngine(std::move(bodies), {PairFinder::all_pairs});
}

/// Angle by which one impact turns the three balls' motion.  [rad]
inline double row_angle(double e)
{
    return std::acos((1.0 + e) / (4.0 * std::sqrt(e)));
}

} // namespace flying
