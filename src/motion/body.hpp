#pragma once

#include "math/rotation.hpp"
#include "math/vec2.hpp"

namespace flying {

/// How a body moves, at one moment of its own.
struct BodyState
{
    Vec2 position = Vec2::Zero(); ///< of the centre of mass [m]
    Vec2 velocity = Vec2::Zero(); ///< [m/s]
    double angle = 0.0;           ///< counter-clockwise, not wrapped [rad]
    double spin = 0.0;            ///< angular velocity [rad/s]
    double time = 0.0;            ///< the moment at which all this holds [s]
};

/// What resists a push. A static body has infinite mass: both inverses are zero.
struct Inertia
{
    double inv_mass = 0.0;              ///< [1/kg]
    double inv_moment_of_inertia = 0.0; ///< about the centre of mass [1/(kg m^2)]
};

/// What decides how two bodies part after an impact.
struct Material
{
    double restitution = 1.0; ///< e, 0 ... 1 [-]
    double friction = 0.0;    ///< mu, >= 0 [-]
};

/// Velocity of the body's point that lies at r from its centre of mass.  [m/s]
[[nodiscard]] inline Vec2 velocity_at(const BodyState& body, const Vec2& r)
{
    return body.velocity + cross(body.spin, r);
}

/// Where the body's own frame lies at its moment.
[[nodiscard]] inline Pose pose_of(const BodyState& body) { return {body.position, Rotation::of(body.angle)}; }

} // namespace flying
