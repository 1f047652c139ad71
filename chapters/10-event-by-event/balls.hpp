#pragma once

#include "events/event_engine.hpp"

namespace flying {

/// A disc that flies, without friction.
/// radius [m]; mass [kg]; x, v  where it starts, and how fast [m], [m/s]; e
/// restitution
inline EventBody ball(double radius, double mass, const Vec2& x, const Vec2& v,
                      double e = 1.0)
{
    EventBody body;
    body.shape = Disc{radius};
    body.flyer.state.position = x;
    body.flyer.state.velocity = v;
    body.inertia = {1.0 / mass, 2.0 / (mass * radius * radius)};
    body.material = {e, 0.0};
    return body;
}

/// A wall: everything behind a line. normal  out of it; offset  of the line along the
/// normal [m]
inline EventBody wall(const Vec2& normal, double offset, double e = 1.0)
{
    EventBody body;
    body.shape = HalfPlane{normal, offset};
    body.material = {e, 0.0};
    body.is_static = true;
    return body;
}

} // namespace flying
