#include <algorithm>
#include <cmath>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {


RestEngine::Gain RestEngine::gain_of(const Group& group) const
{
    Gain gain;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const Mover& old = before_[member];
        const Mover& now = movers_[member];
        const double before =
            0.5 * ((old.v_x * old.v_x + old.v_y * old.v_y) / old.inv_mass + old.spin * old.spin / old.inv_moment);
        const double after =
            0.5 * ((now.v_x * now.v_x + now.v_y * now.v_y) / now.inv_mass + now.spin * now.spin / now.inv_moment);
        const double work = work_of_field(member) / now.inv_mass;
        gain.gained += (after - before) - work;
        const Vec2& field = field_[member];
        const double through_field = field.cwiseProduct(shift_[member]).cwiseAbs().sum();
        const double in_a_step = (span_ * field).squaredNorm(); // the solve's rounding is in proportion to it
        gain.scale += after + before + (through_field + in_a_step) / now.inv_mass;
    }
    return gain;
}



/// The motion of an island as one rigid body that no contact with something static resists: all of it where there is none,
/// what goes along a wall where the normals of all lead the same way, and none otherwise. Slowing an island down
/// relative to that changes no momentum that is its own.
RestEngine::RigidMotion RestEngine::free_motion(const Group& group) const
{
    RigidMotion rigid;
    double mass = 0.0;
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        const Mover& now = movers_[member];
        mass += 1.0 / now.inv_mass;
        rigid.centre += bodies_[member].state.position / now.inv_mass;
        rigid.velocity += Vec2(now.v_x, now.v_y) / now.inv_mass;
    }
    rigid.centre /= mass;
    rigid.velocity /= mass;

    // Where it leans on something static
    Vec2 normal = Vec2::Zero();
    for (const ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        if (!(c.normal > 0.0) || (is_moved(c.a) && is_moved(c.b))) continue;
        const Vec2 n(c.n_x, c.n_y);
        if (normal.isZero(0.0)) normal = n;
        else if (std::abs(cross(normal, n)) > rest_tolerance::k_same_normal) return {};
    }
    if (!normal.isZero(0.0)) {
        rigid.velocity -= normal.dot(rigid.velocity) * normal;
        return rigid;
    }
    double moment = 0.0;
    double turning = 0.0;
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        const Mover& now = movers_[member];
        const Vec2 r = bodies_[member].state.position - rigid.centre;
        turning += cross(r, Vec2(Vec2(now.v_x, now.v_y) - rigid.velocity)) / now.inv_mass + now.spin / now.inv_moment;
        moment += r.squaredNorm() / now.inv_mass + 1.0 / now.inv_moment;
    }
    rigid.spin = turning / moment;
    return rigid;
}



/// Takes energy out of an island's motion relative to a rigid one, as much as there is. What remains to be taken.  [J]
double RestEngine::slow_down(const Group& group, const RigidMotion& rigid, double by)
{
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    const auto velocity_of = [&](int member) {
        return Vec2(rigid.velocity + cross(rigid.spin, Vec2(bodies_[member].state.position - rigid.centre)));
    };
    double energy = 0.0;
    double mixed = 0.0; // what changes with the relative motion beside its own energy [J]
    for (const int member : members) {
        const Mover& now = movers_[member];
        const Vec2 common = velocity_of(member);
        const Vec2 own = Vec2(now.v_x, now.v_y) - common;
        const double spin = now.spin - rigid.spin;
        energy += 0.5 * (own.squaredNorm() / now.inv_mass + spin * spin / now.inv_moment);
        mixed += common.dot(own) / now.inv_mass + rigid.spin * spin / now.inv_moment;
    }

    // With a share s of the relative motion its energy is  energy s^2 + mixed s
    const double left = energy + mixed - by;
    const double root = mixed * mixed + 4.0 * energy * left;
    const double share = energy > 0.0 && root > 0.0 ? std::clamp((std::sqrt(root) - mixed) / (2.0 * energy), 0.0, 1.0) : 0.0;

    for (const int member : members) {
        Mover& now = movers_[member];
        const Vec2 common = velocity_of(member);
        now.v_x = common.x() + share * (now.v_x - common.x());
        now.v_y = common.y() + share * (now.v_y - common.y());
        now.spin = rigid.spin + share * (now.spin - rigid.spin);
    }
    return by - ((energy + mixed) - (energy * share + mixed) * share);
}



/// The one limit of energy: what a step has gained beyond the field's work is taken from the motion of bodies relative to
/// each other; where that isn't enough from all motion, and then from the way that they rise. Counted, since it changes
/// the motion.
void RestEngine::limit_energy(const Group& group)
{
    const Gain gain = gain_of(group);
    const double rounding = rest_tolerance::k_rounding * gain.scale;
    if (gain.gained <= rounding) return;
    ++counts_.limited;
    energy_limited_ += gain.gained;
    if (slow_down(group, free_motion(group), gain.gained) <= rounding) return;
    if (slow_down(group, {}, gain_of(group).gained) <= rounding) return;

    // What has nothing left to pay with rises no further than the motion before would have carried it
    const Gain rest = gain_of(group);
    double lift = 0.0;
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    for (const int member : members) lift -= work_of_field(member) / movers_[member].inv_mass;
    const double part = rest.gained < lift && !stood(group) ? 1.0 - rest.gained / lift : 0.0;
    for (const int member : members) {
        shift_[member] *= part;
        turn_[member] *= part;
    }
}


} // namespace flying
