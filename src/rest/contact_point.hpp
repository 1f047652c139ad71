#pragma once

#include <limits>

namespace flying {

/// What the solver knows of a body: how it moves, and how it resists. A static body has
/// both inverses zero and never moves, so that no push needs to ask.
struct Mover
{
    double v_x = 0.0;        ///< [m/s]
    double v_y = 0.0;        ///< [m/s]
    double spin = 0.0;       ///< [rad/s]
    double inv_mass = 0.0;   ///< [1/kg]
    double inv_moment = 0.0; ///< about the centre of mass [1/(kg m^2)]
};

/// One point at which two bodies lean on each other, or might before the step ends. Normal n from A to B; tangent: n
/// turned a quarter counter-clockwise. The arm of a push along n is r x n, that of one along the tangent r . n.
struct ContactPoint
{
    int a = 0;
    int b = 0;
    int pair = 0;     ///< the engine's pair that it belongs to
    int own = 0;      ///< which of that pair's points it is
    double n_x = 0.0; ///< unit normal
    double n_y = 0.0;
    double normal_arm_a = 0.0;  ///< r_a x n [m]
    double normal_arm_b = 0.0;  ///< r_b x n [m]
    double tangent_arm_a = 0.0; ///< r_a . n [m]
    double tangent_arm_b = 0.0; ///< r_b . n [m]
    double normal_mass = 0.0;   ///< effective mass along the normal [kg]
    double tangent_mass = 0.0;  ///< effective mass along the tangent [kg]
    double friction = 0.0;      ///< mu of the pair
    double restitution = 0.0;   ///< e of the pair
    double gap = 0.0;           ///< at the start of the step, negative where the two overlap [m]
    double bound = 0.0;         ///< least normal velocity with which the step may end [m/s]
    double normal = 0.0;        ///< impulse along the normal, >= 0 [N s]
    double tangent = 0.0;       ///< impulse along the tangent, at most mu times the normal one [N s]
    double closes_at =
        std::numeric_limits<double>::infinity(); ///< when its pair is expected to close, after the start [s]
    double closing_speed = 0.0;                  ///< with which it is expected to do so [m/s]
};

/// An impact there loses nothing: it is elastic, and smooth.
[[nodiscard]] inline bool is_lossless(const ContactPoint& c)
{
    return c.restitution == 1.0 && c.friction == 0.0;
}

/// Normal velocity of B relative to A, from that of their centres and from both spins.  [m/s]
[[nodiscard]] inline double normal_speed(const ContactPoint& c, double v_x, double v_y, double spin_a, double spin_b)
{
    return (c.n_x * v_x + c.n_y * v_y) + (spin_b * c.normal_arm_b - spin_a * c.normal_arm_a);
}
[[nodiscard]] inline double normal_speed(const ContactPoint& c, const Mover& a, const Mover& b)
{
    return normal_speed(c, b.v_x - a.v_x, b.v_y - a.v_y, a.spin, b.spin);
}

/// Tangential velocity of B relative to A.  [m/s]
[[nodiscard]] inline double tangent_speed(const ContactPoint& c, double v_x, double v_y, double spin_a, double spin_b)
{
    return (c.n_x * v_y - c.n_y * v_x) + (spin_b * c.tangent_arm_b - spin_a * c.tangent_arm_a);
}
[[nodiscard]] inline double tangent_speed(const ContactPoint& c, const Mover& a, const Mover& b)
{
    return tangent_speed(c, b.v_x - a.v_x, b.v_y - a.v_y, a.spin, b.spin);
}

/// Effective mass of a push between two bodies.  [kg]
/// shifts  sum of the inverse masses, as the push meets them [1/kg]
[[nodiscard]] inline double effective_mass(double shifts, const Mover& a, const Mover& b, double arm_a, double arm_b)
{
    return 1.0 / (shifts + (a.inv_moment * (arm_a * arm_a) + b.inv_moment * (arm_b * arm_b)));
}

/// What a push does to both bodies; A gets as much the other way.
struct PushOnBoth
{
    double x = 0.0;        ///< on B [N s]
    double y = 0.0;        ///< on B [N s]
    double moment_a = 0.0; ///< to be taken from A [N m s]
    double moment_b = 0.0; ///< on B [N m s]
};

/// A push by j along the normal and q along the tangent.  [N s]
[[nodiscard]] inline PushOnBoth push_on_both(const ContactPoint& c, double j, double q)
{
    return {j * c.n_x - q * c.n_y, j * c.n_y + q * c.n_x, j * c.normal_arm_a + q * c.tangent_arm_a,
            j * c.normal_arm_b + q * c.tangent_arm_b};
}

/// Push B by j along the normal and q along the tangent, and A by as much the other
/// way.  [N s]
inline void push(const ContactPoint& c, double j, double q, Mover& a, Mover& b)
{
    const PushOnBoth p = push_on_both(c, j, q);
    a.v_x -= a.inv_mass * p.x;
    a.v_y -= a.inv_mass * p.y;
    a.spin -= a.inv_moment * p.moment_a;
    b.v_x += b.inv_mass * p.x;
    b.v_y += b.inv_mass * p.y;
    b.spin += b.inv_moment * p.moment_b;
}

} // namespace flying
