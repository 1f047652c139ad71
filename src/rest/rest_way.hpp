#pragma once

#include <vector>

#include "motion/body.hpp"

namespace flying {

/// A stretch of a body's way through a step: no impact within it, one at its start perhaps.
struct Leg
{
    double length = 0.0; ///< [s]
    BodyState start;     ///< with the velocities after such an impact
    Vec2 shift = Vec2::Zero();
    double turn = 0.0;
    Vec2 velocity = Vec2::Zero(); ///< with which it ends, like the spin
    double spin = 0.0;
    enum class Kind : unsigned char
    {
        even,  ///< straight on, while velocities change evenly: all that is known where impacts and loads mix
        bent,  ///< velocities change evenly, and the way bends as they do
        curved ///< the way is smooth, and velocities are its slope
    };
    Kind kind = Kind::bent;
};

/// Where a body is on its way, and how it moves, a time after the step began.  [s]
/// legs  of one body, in order, at least one
[[nodiscard]] BodyState along(const std::vector<Leg>& legs, double time);

} // namespace flying
