#include "rest/step_motion.hpp"

#include "response/push_line.hpp"

namespace flying {
Mover mover_of(const RestBody& body)
{
    if (body.is_static) return {};
    const BodyState& s = body.state;
    return {s.velocity.x(), s.velocity.y(), s.spin, body.inertia.inv_mass, body.inertia.inv_moment_of_inertia};
}

StepMotion::StepMotion(const RestBodies& bodies, double length) : span(length)
{
    const std::size_t count = bodies.list.size();
    for (const RestBody& body : bodies.list) {
        now.push_back(mover_of(body));
        field.push_back(body.acceleration);
        field_size.push_back(body.acceleration.norm());
    }
    before = now;
    shift.assign(count, Vec2::Zero());
    turn.assign(count, 0.0);
    end_poses = bodies.poses;
    reach.assign(count, 0.0);
    pull.assign(count, Vec2::Zero());
    expected_angular_acceleration.assign(count, 0.0);
}

void StepMotion::set_arms(ContactPoint& c, const Vec2& n, const Vec2& r_a, const Vec2& r_b) const
{
    const Mover& a = now[c.a];
    const Mover& b = now[c.b];
    c.n_x = n.x();
    c.n_y = n.y();
    c.normal_arm_a = normal_arm(r_a, n);
    c.normal_arm_b = normal_arm(r_b, n);
    c.tangent_arm_a = r_a.dot(n);
    c.tangent_arm_b = r_b.dot(n);
    const double mass = a.inv_mass + b.inv_mass;
    c.normal_mass =
        1.0 /
        (mass + (a.inv_moment * (c.normal_arm_a * c.normal_arm_a) + b.inv_moment * (c.normal_arm_b * c.normal_arm_b)));
    c.tangent_mass = 1.0 / (mass + (a.inv_moment * (c.tangent_arm_a * c.tangent_arm_a) +
                                    b.inv_moment * (c.tangent_arm_b * c.tangent_arm_b)));
}

} // namespace flying
