#pragma once

#include <span>

#include "motion/body.hpp"

namespace flying {

/// One point at which two bodies A and B touch at the moment of an impact.
struct ImpactPoint
{
    Vec2 r_a = Vec2::Zero();    ///< from A's centre of mass to the point [m]
    Vec2 r_b = Vec2::Zero();    ///< from B's centre of mass to the point [m]
    Vec2 normal = Vec2::Zero(); ///< unit vector from A to B
};

/// Spin and velocity of one body, and what resists their change.
struct ImpactBody
{
    Vec2 velocity = Vec2::Zero(); ///< [m/s]
    double spin = 0.0;            ///< [rad/s]
    Inertia inertia;
};

/// What an impact did.
struct ImpactResult
{
    Vec2 velocity_a = Vec2::Zero(); ///< after [m/s]
    Vec2 velocity_b = Vec2::Zero(); ///< after [m/s]
    double spin_a = 0.0;            ///< after [rad/s]
    double spin_b = 0.0;            ///< after [rad/s]
    bool any_push = false;          ///< some point was approaching and was pushed
    bool ended = true;              ///< no point still approaches; false where rounds ran out
};

/// A pair's material: the larger restitution and the geometric mean of the frictions.
[[nodiscard]] Material combine(const Material& a, const Material& b);

/// The velocities after two bodies struck each other at one or several points at once.
///
/// Only approaching points are pushed; contact never pulls. One approaching point: Coulomb's friction in the course of
/// the impact (slip, reversal, stick), restitution by Stronge's energetic law, which equals Newton's where friction
/// doesn't couple to the normal. Several: (1 + e) times the impulses that stop all approaching and resting points at
/// once, with friction against the slip they leave (see several_points.hpp); without friction, Newton's law at each.
/// Rounds of this until no point approaches. Energy never rises beyond rounding; at e = 1 without friction it is kept
/// to rounding.
///
/// points    of this pair, one or more, in any order; the result depends on their order by rounding only
/// material  of the pair: restitution 0 ... 1, friction >= 0
/// rests     a point that parts no faster rests, beyond those that do for rounding [m/s]
[[nodiscard]] ImpactResult resolve_impact(const ImpactBody& a, const ImpactBody& b, std::span<const ImpactPoint> points,
                                          const Material& material, double rests = 0.0);

} // namespace flying
