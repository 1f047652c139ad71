#pragma once

#include "motion/body.hpp"

namespace flying {

/// Where a point is that started at x with velocity v, a time t later, under g.   [m]
[[nodiscard]] inline Vec2 position_after(const Vec2& x, const Vec2& v, const Vec2& g,
                                         double t)
{
    return x + t * (v + (0.5 * t) * g);
}

/// The body at another moment, under a constant acceleration. Closed form: the error is
/// rounding, however far the step.
///
/// body  its state at body.time
/// g     acceleration, zero where there is no field         [m/s^2]
/// time  any moment, earlier ones included                  [s]
[[nodiscard]] inline BodyState flight(const BodyState& body, const Vec2& g, double time)
{
    const double t = time - body.time;
    BodyState after = body;
    after.position = position_after(body.position, body.velocity, g, t);
    after.velocity = body.velocity + t * g;
    after.angle = body.angle + body.spin * t;
    after.time = time;
    return after;
}

} // namespace flying
