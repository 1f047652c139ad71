#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

// [rest.rebound.limits]
/// Halvings of the share of rebound that is kept where friction would turn a rebound into more than came in.
constexpr int k_rebound_halvings = 6;
/// [energies] Work below this is rounding.
constexpr double k_work = 0x1p-40;
/// Parts of one step.
constexpr int k_most_parts = 4;
/// Bisections until a part of a step slips to its end.
constexpr int k_part_halvings = 10;
// [rest.rebound.limits]

} // namespace

// [rest.impacts]
/// What the points of a small group bear when the step ends, and so what of their impulses was the impact.
void RestEngine::find_impacts(Group& group)
{
    // One point by itself is struck by its own approach; several share what strikes one of them
    const std::span<ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    const auto struck = [](const ContactPoint& c) { return c.impact > rest_tolerance::k_load * c.normal; };
    group.knows_loads = points.size() == 1;
    if (is_crowd(group) || group.knows_loads || std::none_of(points.begin(), points.end(), struck)) return;

    // Go on for as long again as the step ends: whoever bears then, and is not thrown back, keeps its normal speed. A gap
    // that closes evenly until the end of the step leaves all of its impulse to the load, and that goes on as it is
    part_movers_.resize(movers_.size());
    load_points_.assign(points.begin(), points.end());
    const auto at_end = [&](int body) -> const Mover& { return is_moved(body) ? part_movers_[body] : movers_[body]; };
    const auto closes = [&](const ContactPoint& c) { return c.impact == 0.0 && c.gap > touch_gap(c.a, c.b); };
    for (const int member : members) {
        Mover& mover = movers_[member];
        part_movers_[member] = mover;
        mover.v_x += span_ * field_[member].x();
        mover.v_y += span_ * field_[member].y();
    }
    for (ContactPoint& c : load_points_) {
        const bool is_thrown = c.impact > 0.0 && c.bound != 0.0;
        const bool goes_on = closes(c);
        const bool bears = c.normal > 0.0 && !is_thrown && !goes_on;
        const double share = span_ / c.left;
        if (goes_on) push(c, share * c.normal, share * c.tangent, movers_[c.a], movers_[c.b]);
        c.bound = bears ? normal_speed(c, at_end(c.a), at_end(c.b)) : -std::numeric_limits<double>::infinity();
        if (!bears) c.normal = c.tangent = 0.0;
    }
    const double rounding = rest_tolerance::k_content * top_speed(group);
    group.knows_loads = solver_.solve(movers_, members, load_points_, rounding);
    for (const int member : members) movers_[member] = part_movers_[member];
    for (std::size_t k = 0; k < points.size() && group.knows_loads; ++k) {
        ContactPoint& c = points[k];
        if (closes(c)) continue;
        c.impact = c.normal - load_points_[k].normal * (c.left / span_);
    }
}
// [rest.impacts]

// [rest.rebound]
double RestEngine::work_of_contacts(const Group& group, double& energy)
{
    double work = 0.0;
    energy = 0.0;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const Mover& now = movers_[member];
        const Vec2 free(before_[member].v_x + span_ * field_[member].x(),
                        before_[member].v_y + span_ * field_[member].y());
        const double shift = free.squaredNorm() / now.inv_mass;
        const double turn = before_[member].spin * before_[member].spin / now.inv_moment;
        const double shift_after = (now.v_x * now.v_x + now.v_y * now.v_y) / now.inv_mass;
        work += (shift_after - shift) + (now.spin * now.spin / now.inv_moment - turn);
        energy += shift + turn;
    }
    return work;
}

void RestEngine::limit_rebound(Group& group)
{
    // Without rebound contacts never do work; with friction and several points, Newton's law may
    double energy = 0.0;
    if (work_of_contacts(group, energy) <= k_work * energy) return;
    double low = 0.0;
    double high = 1.0;
    double share = 1.0;
    const auto rescale = [&](double to) {
        for (int k = 0; k < group.point_count; ++k) {
            ContactPoint& c = points_[group.first_point + k];
            if (c.bound > 0.0) c.bound *= to / share;
        }
        share = to;
        find_impulses(group, span_);
    };
    for (int k = 0; k < k_rebound_halvings; ++k) {
        const double middle = 0.5 * (low + high);
        rescale(middle);
        (work_of_contacts(group, energy) <= k_work * energy ? low : high) = middle;
    }
    if (share != low) rescale(std::max(low, 0x1p-60));
}
// [rest.rebound]

// [rest.slip_ends]
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
    for (const ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        if (c.left != dt || c.impact > 0x1p-30 * c.normal) return;
    }
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
// [rest.slip_ends]

} // namespace flying
