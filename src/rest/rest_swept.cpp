#include <algorithm>
#include <cmath>

#include "rest/rest_engine.hpp"

namespace flying {
namespace {

// [rest.swept.limits]
/// [speeds that the field gives in a step] A group that was slower and stays so is at rest: what it was about to do is
/// the price of its sleep. Its bodies would speed up by twice as much of the field's acceleration at most.
constexpr double k_calm = 0x1p-8;
/// [k_calm] Where no point asks for a greater change, impulses stay as they are, to the bit.
constexpr double k_content_enough = 0x1p-2;
/// [speeds that the field gives in a step] In slower groups nothing is pushed apart any more: that would shake them.
constexpr double k_slow = 4.0;
/// [greatest speeds] Points that would have to close faster than that wait for the end of the sweeps.
constexpr double k_far = 2.0;
/// Share of an overlap that one step takes off.
constexpr double k_push_share = 0.25;
// [rest.swept.limits]

} // namespace

// [rest.swept]
/// A group too large to be solved whole: each step goes on with the sweeps of the last.
void RestEngine::sweep_large(Group& group)
{
    group.is_exact = false;
    const std::span<ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    const double field = field_speed(group);
    const double before = greatest_speed(before_, radius_, members);
    bound_swept(group, before <= k_calm * field);
    set_free(group, span_);
    GroupSolver::SweepPlan plan;
    plan.sweeps = options_.sweeps;
    plan.looks_ahead = true;
    plan.far_from_closing = k_far * std::max(before, field);
    plan.time = span_;
    plan.tolerance = k_content_enough * k_calm * field;
    if (before > k_slow * field) {
        plan.push_sweeps = options_.push_sweeps;
        plan.push_share = k_push_share;
    }
    solver_.sweep_group(movers_, members, points, plan, place_movers_);

    // What hardly moves comes to rest
    const double after = greatest_speed(movers_, radius_, members);
    if (before <= k_calm * field && after <= k_calm * field) {
        for (const int member : members) {
            Mover& mover = movers_[member];
            mover.v_x = mover.v_y = mover.spin = 0.0;
            place_movers_[member] = mover;
        }
    }
    move_as_swept(group);
}

double RestEngine::greatest_speed(std::span<const Mover> movers, std::span<const double> radius,
                                  std::span<const int> members)
{
    double top = 0.0;
    for (const int member : members) {
        const Mover& mover = movers[member];
        top = std::max({top, std::abs(mover.v_x), std::abs(mover.v_y), std::abs(mover.spin) * radius[member]});
    }
    return top;
}

void RestEngine::move_as_swept(const Group& group)
{
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const Mover& pushed = place_movers_[member];
        shift_[member] = span_ * Vec2(pushed.v_x, pushed.v_y);
        turn_[member] = span_ * pushed.spin;
    }
}
// [rest.swept]

// [rest.swept.bounds]
void RestEngine::bound_swept(const Group& group, bool is_calm)
{
    const double field = field_speed(group);
    for (int k = 0; k < group.point_count; ++k) {
        // Gaps as they are when the step begins: all of it passes with the velocities that it ends with
        ContactPoint& c = points_[group.first_point + k];
        const double moment = span_ - c.left;
        const double u = normal_speed(c, before_[c.a], before_[c.b]);
        if (moment > 0.0) c.gap = std::max(c.gap, 0.0) - moment * (u + 0.5 * moment * fall_of(c));
        c.left = span_;
        c.bound = -std::max(c.gap, 0.0) / span_;
        // In a calm group nobody comes to close a gap: what bears over one that a calm speed would close goes on to bear,
        // or its load would wane for minutes while nothing moves
        if (is_calm && c.normal > 0.0 && -c.bound <= k_calm * field) c.bound = 0.0;
        c.impact = 0.0;

        // Whoever comes to touch is thrown back, unless the field would end that within the step
        const bool comes = u < 0.0 && c.normal == 0.0 && c.gap + span_ * u < 0.0;
        if (!comes) continue;
        const double rebound = -c.restitution * u;
        const bool rests = 2.0 * rebound <= field;
        if (!rests) c.bound = rebound;
        c.impact = c.normal_mass * (rests ? -u : rebound - u);
        if (!rests) ++counts_.impacts;
    }
}
// [rest.swept.bounds]

} // namespace flying
