#include "rest/step_motion.hpp"

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

} // namespace flying
