#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {


/// Parts of one step.
constexpr int k_most_parts = 4;
/// Bisections until a part of a step slips to its end.
constexpr int k_part_halvings = 10;


} // namespace


const Mover& RestEngine::start_of_part(int member) const
{
    return parted_ ? part_movers_[member] : before_[member];
}

bool RestEngine::any_slip_ended(const Group& group, double still) const
{
    for (int k = 0; k < group.point_count; ++k) {
        const ContactPoint& c = points_[group.first_point + k];
        if (!(c.normal > 0.0) || c.friction == 0.0) continue;
        const double slip = tangent_speed(c, start_of_part(c.a), start_of_part(c.b));
        const double after = tangent_speed(c, movers_[c.a], movers_[c.b]);
        if (std::abs(slip) > still && (slip > 0.0 ? after <= still : after >= -still)) return true;
    }
    return false;
}

void RestEngine::part_where_slip_ends(Group& group)
{
    const double still = rest_tolerance::k_slip * field_speed(group);
    const double dt = span_;
    double left = dt;
    if (field_speed(group) == 0.0 || !any_slip_ended(group, still)) return;
    part_movers_.resize(movers_.size());
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        part_movers_[member] = before_[member];
    }
    parted_ = true;
    for (int part = 0; part < k_most_parts; ++part) {
        // Find a time short enough for all slips to last; from there each goes on evenly to its end
        double time = left;
        double part_of_load = 1.0;
        int halvings = 0;
        for (; halvings < k_part_halvings; ++halvings) {
            time *= 0.5;
            part_of_load = 0.5;
            scale_impulses(group, part_of_load);
            find_impulses(group, time);
            if (!any_slip_ended(group, still)) break;
        }
        if (halvings == k_part_halvings) {
            // It ends at once
            scale_impulses(group, left / time);
            find_impulses(group, left);
            break;
        }
        double end = left;
        for (int k = 0; k < group.point_count; ++k) {
            const ContactPoint& c = points_[group.first_point + k];
            if (!(c.normal > 0.0) || c.friction == 0.0) continue;
            const double slip = tangent_speed(c, start_of_part(c.a), start_of_part(c.b));
            const double after = tangent_speed(c, movers_[c.a], movers_[c.b]);
            if (std::abs(slip) > still && std::abs(after) < std::abs(slip))
                end = std::min(end, time * (slip / (slip - after)));
        }
        scale_impulses(group, end / time);
        find_impulses(group, end);
        add_part(group, end);
        left -= end;
        if (!(left > 0x1p-40 * dt)) break;
        scale_impulses(group, left / end);
        find_impulses(group, left);
        if (!any_slip_ended(group, still)) break;
    }
    if (left > 0.0) {
        // The rest of the step, and the mean force as if it had lasted for all of it
        add_part(group, left);
        scale_impulses(group, dt / left);
    }
    parted_ = false;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const Mover& old = before_[member];
        const Mover& now = movers_[member];
        shift_[member] -= dt * Vec2(0.5 * (old.v_x + now.v_x), 0.5 * (old.v_y + now.v_y));
        turn_[member] -= dt * (0.5 * (old.spin + now.spin));
    }
}

void RestEngine::scale_impulses(const Group& group, double factor)
{
    for (int k = 0; k < group.point_count; ++k) {
        ContactPoint& c = points_[group.first_point + k];
        c.normal *= factor;
        c.tangent *= factor;
    }
}

void RestEngine::add_part(const Group& group, double time)
{
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const Mover& old = part_movers_[member];
        const Mover& now = movers_[member];
        shift_[member] += time * Vec2(0.5 * (old.v_x + now.v_x), 0.5 * (old.v_y + now.v_y));
        turn_[member] += time * (0.5 * (old.spin + now.spin));
        part_movers_[member] = now;
    }
}


} // namespace flying
