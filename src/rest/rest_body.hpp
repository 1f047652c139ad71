#pragma once

#include "geometry/shape.hpp"
#include "motion/body.hpp"

namespace flying {

/// One body as the resting integrator knows it.
struct RestBody
{
    Shape shape;
    BodyState state; ///< `state.time` is set by the engine
    Inertia inertia; ///< both zero for a static body
    Material material;
    Vec2 acceleration = Vec2::Zero(); ///< of a field that is the same everywhere [m/s^2]
    bool is_static = false;           ///< never moves: no velocity, no spin
    bool is_active = true;            ///< false: elsewhere; touches nothing, and keeps its state
};

} // namespace flying
