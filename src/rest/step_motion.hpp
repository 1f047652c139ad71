#pragma once

#include <vector>

#include "math/rotation.hpp"
#include "response/push_line.hpp"
#include "rest/contact_point.hpp"
#include "rest/rest_bodies.hpp"

namespace flying {

/// A body as the solver sees it.
[[nodiscard]] Mover mover_of(const RestBody& body);

/// How all bodies go through a step, or a part of one: where it begins, what acts, and where it leads.
struct StepMotion
{
    explicit StepMotion(const RestBodies& bodies, double length);

    double span = 0.0;  ///< length of the step, or of the part of one, that is being made [s]
    double after = 0.0; ///< from its end to that of the whole step [s]

    std::vector<Mover> before;   ///< velocities as it begins, those after impacts at that moment
    std::vector<Mover> now;      ///< velocities as it ends
    std::vector<Vec2> shift;     ///< ways that it leads [m]
    std::vector<double> turn;    ///< turns that it makes [rad]
    std::vector<Pose> end_poses; ///< where a look ahead takes bodies to be
    std::vector<double> reach;   ///< how far each may get [m]

    std::vector<Vec2> field;        ///< accelerations that the field gives [m/s^2]
    std::vector<double> field_size; ///< their sizes
    std::vector<Vec2> pull;         ///< accelerations that are expected: of the last step, or the field's [m/s^2]
    std::vector<double> expected_angular_acceleration; ///< the same of spins [rad/s^2]

    /// Whether anything moves a body.
    [[nodiscard]] bool is_moved(int body) const { return now[body].inv_mass > 0.0; }

    /// Normal acceleration of B relative to A at a point, if they go on as they did.  [m/s^2]
    [[nodiscard]] double fall_of(const ContactPoint& c) const
    {
        const Vec2 more = pull[c.b] - pull[c.a];
        return (c.n_x * more.x() + c.n_y * more.y()) + (expected_angular_acceleration[c.b] * c.normal_arm_b -
                                                        expected_angular_acceleration[c.a] * c.normal_arm_a);
    }

    /// The same if nothing but the field acts on them.
    [[nodiscard]] double weight_of(const ContactPoint& c) const
    {
        const Vec2 more = field[c.b] - field[c.a];
        return c.n_x * more.x() + c.n_y * more.y();
    }

    /// Adds the way of a body that goes for so long [s] by the mean of two velocities.
    void add_mean_way(int body, const Mover& one, const Mover& two, double time)
    {
        shift[body] += time * Vec2(0.5 * (one.v_x + two.v_x), 0.5 * (one.v_y + two.v_y));
        turn[body] += time * (0.5 * (one.spin + two.spin));
    }

    /// Normal, arms and effective masses of a point.
    /// r_a, r_b  from the centres of the two bodies to it [m]
    void set_arms(ContactPoint& c, const Vec2& normal, const Vec2& r_a, const Vec2& r_b) const;
};

// [rest.contacts.arms]
inline void StepMotion::set_arms(ContactPoint& c, const Vec2& n, const Vec2& r_a, const Vec2& r_b) const
{
    const Mover& a = now[c.a];
    const Mover& b = now[c.b];
    c.n_x = n.x();
    c.n_y = n.y();
    c.normal_arm_a = normal_arm(r_a, n);
    c.normal_arm_b = normal_arm(r_b, n);
    c.tangent_arm_a = r_a.dot(n);
    c.tangent_arm_b = r_b.dot(n);
    const double shifts = a.inv_mass + b.inv_mass;
    c.normal_mass = effective_mass(shifts, a, b, c.normal_arm_a, c.normal_arm_b);
    c.tangent_mass = effective_mass(shifts, a, b, c.tangent_arm_a, c.tangent_arm_b);
}
// [rest.contacts.arms]

} // namespace flying
