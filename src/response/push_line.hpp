#pragma once

#include <cmath>

#include "math/tolerance.hpp"
#include "response/impact.hpp"

namespace flying {

/// The velocities of the two bodies of an impact.
struct PairMotion
{
    Vec2 velocity_a = Vec2::Zero(); ///< [m/s]
    Vec2 velocity_b = Vec2::Zero(); ///< [m/s]
    double spin_a = 0.0;            ///< [rad/s]
    double spin_b = 0.0;            ///< [rad/s]
};

/// What resists a push between the two bodies of an impact.
struct PairInertia
{
    Inertia a;
    Inertia b;

    /// 1/m_a + 1/m_b, what a push through both centres would meet  [1/kg]
    [[nodiscard]] double inv_mass() const { return a.inv_mass + b.inv_mass; }
};

/// The line along which two bodies push each other: a direction and two arms.
struct PushLine
{
    Vec2 direction = Vec2::Zero(); ///< in which B is pushed; A is pushed the other way
    double arm_a = 0.0;            ///< r_a x direction [m]
    double arm_b = 0.0;            ///< r_b x direction [m]
};

/// Normal and tangent at one point. The tangent is the normal, turned a quarter counter-clockwise.
struct PointFrame
{
    PushLine normal;
    PushLine tangent;
};

/// Arm of a push along unit vector n at r. [m]
///
/// A normal that goes through the centre of mass has no arm; rounding gives it one. Such an
/// arm is taken for none, so that a frictionless disc never spins.
[[nodiscard]] inline double normal_arm(const Vec2& r, const Vec2& n)
{
    const double arm = cross(r, n);
    const double depth = r.dot(n);
    return std::abs(arm) <= tolerance::k_central * std::abs(depth) ? 0.0 : arm;
}

/// Normal and tangent at a point, with the arms of pushes along them. r x perp(n) is r.n.
[[nodiscard]] inline PointFrame frame_at(const ImpactPoint& point)
{
    const Vec2& n = point.normal;
    return {{n, normal_arm(point.r_a, n), normal_arm(point.r_b, n)},
            {perp(n), point.r_a.dot(n), point.r_b.dot(n)}};
}

/// Speed of B's point relative to A's, seen along a line.  [m/s]
///
/// Along a normal it is negative when they approach.
///
/// The point at r moves at v + omega x r, and (omega x r).n = omega (r x n): the arm again.
[[nodiscard]] inline double speed_along(const PushLine& line, const PairMotion& motion)
{
    const double shift = (motion.velocity_b - motion.velocity_a).dot(line.direction);
    const double turn = motion.spin_b * line.arm_b - motion.spin_a * line.arm_a;
    return shift + turn;
}

/// Change of the speed along a line for one N s along it: the inverse of its effective mass.  [1/kg]
///
/// 1/m_a + 1/m_b + (r_a x n)^2/I_a + (r_b x n)^2/I_b, for a direction n of length 1.
[[nodiscard]] inline double inverse_mass(const PushLine& line, const PairInertia& inertia)
{
    const double turn_a = inertia.a.inv_moment_of_inertia * (line.arm_a * line.arm_a);
    const double turn_b = inertia.b.inv_moment_of_inertia * (line.arm_b * line.arm_b);
    return inertia.inv_mass() + (turn_a + turn_b);
}

/// Change of the speed along `seen` for one N s along `pushed`; symmetric.  [1/kg]
[[nodiscard]] inline double coupling(const PushLine& seen, const PushLine& pushed, const PairInertia& inertia)
{
    const double shift = inertia.inv_mass() * seen.direction.dot(pushed.direction);
    const double turn_a = inertia.a.inv_moment_of_inertia * (seen.arm_a * pushed.arm_a);
    const double turn_b = inertia.b.inv_moment_of_inertia * (seen.arm_b * pushed.arm_b);
    return shift + (turn_a + turn_b);
}

/// A sum of pushes: impulse on B, and moments about both centres. A takes the opposite.
struct PairPush
{
    Vec2 impulse = Vec2::Zero(); ///< [N s]
    double moment_a = 0.0;       ///< to be taken from A's spin [N m s]
    double moment_b = 0.0;       ///< to be given to B's spin [N m s]

    /// Add an impulse of j along a line.
    void add(const PushLine& line, double j)
    {
        impulse += j * line.direction;
        moment_a += j * line.arm_a;
        moment_b += j * line.arm_b;
    }
};

/// The motion after a push.
[[nodiscard]] inline PairMotion pushed(const PairMotion& motion, const PairPush& push,
                                       const PairInertia& inertia)
{
    return {motion.velocity_a - inertia.a.inv_mass * push.impulse,
            motion.velocity_b + inertia.b.inv_mass * push.impulse,
            motion.spin_a - inertia.a.inv_moment_of_inertia * push.moment_a,
            motion.spin_b + inertia.b.inv_moment_of_inertia * push.moment_b};
}

} // namespace flying
