#include <algorithm>
#include <cmath>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/sweeps.hpp"

namespace flying {
namespace {

// [rest.solve.limits]
/// Points of the largest group whose step is parted where slip ends.
constexpr int k_most_parted = 12;

/// Bodies of the largest group that is solved whole however it moves, and whatever it takes; more are a heap.
constexpr int k_most_whole = 64;

/// [complaints] Impulses that complain less by this factor are worth a change.
constexpr double k_much_better = 2.0;

/// [speeds that the field gives in a step] Impulses that complain more don't let anyone stand.
constexpr double k_slight = 0x1p-6;

/// [speeds that the field gives in a step] A tall group that moves no faster stands, or begins to fall.
constexpr double k_standing = 4.0;
// [rest.solve.limits]

} // namespace

// [rest.solve.whole]
bool RestEngine::is_heap(const Group& group)
{
    return group.member_count > k_most_whole;
}

bool RestEngine::is_solved_whole(const Group& group) const
{
    // Small groups; and tall ones in which each leans on hardly more than one other, whose equations stay sparse
    if (group.member_count <= options_.most_solved) return true;
    int pairs = 0;
    int last = -1;
    for (int k = 0; k < group.point_count; ++k) {
        const int pair = points_[group.first_point + k].pair;
        if (pair != last) ++pairs;
        last = pair;
    }
    const bool is_tall = pairs <= rest_tolerance::k_tall * group.member_count;
    return is_tall && top_speed(group) <= k_standing * field_speed(group);
}
// [rest.solve.whole]

// [rest.solve]
void RestEngine::solve_group(Group& group)
{
    if (group.point_count == 0) {
        fly(group);
        return;
    }
    group.is_exact = is_solved_whole(group);
    if (!group.is_exact) {
        sweep_large(group);
        return;
    }
    const bool any_bounce = set_bounds(group);
    const bool leans = is_heap(group) && !any_bounce;
    if (leans && top_speed(group) > k_standing * field_speed(group)) {
        sweep_large(group);
        return;
    }
    if (any_bounce && is_crowd(group)) {
        solve_crowd(group);
        return;
    }
    find_impulses(group, span_);
    if (leans && !group.is_content) {
        // It would cost more than it brings to look on; sweeps go on from what bore before
        for (ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) recall_load(c);
        sweep_large(group);
        return;
    }
    if (any_bounce) limit_rebound(group);
    const bool is_followed = !any_bounce && follow_curves(group);
    if (!any_bounce && !is_followed && group.point_count <= k_most_parted) part_where_slip_ends(group);
    if (!is_followed) find_impacts(group);
    calm(group);
}

void RestEngine::set_free(const Group& group, double time)
{
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        Mover& mover = movers_[member];
        mover = start_of_part(member);
        mover.v_x += time * field_[member].x();
        mover.v_y += time * field_[member].y();
    }
}

void RestEngine::find_impulses(Group& group, double time)
{
    set_free(group, time);
    const std::span<ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    // Whoever stands from the start, and bears for the first time, is worth a search
    const bool is_new =
        stood(group) && std::all_of(points.begin(), points.end(), [](const ContactPoint& c) { return c.normal == 0.0; });
    const Effort effort = is_heap(group) && !is_new ? Effort::brief : Effort::full;
    group.is_content = solver_.solve(movers_, members, points, rest_tolerance::k_content * top_speed(group), effort);
    if (!group.is_content && !is_heap(group) && stood(group)) keep_loads(group, time);
}
// [rest.solve]

// [rest.solve.keep]
bool RestEngine::stood(const Group& group) const
{
    return greatest_speed(before_, radius_, std::span(members_).subspan(group.first_member, group.member_count)) == 0.0;
}

/// Of a group that stands, and whose impulses no solve makes right: those of the step before remain, unless the new ones
/// are much better. So they stop changing, and the group falls asleep. Where any were known and little is wrong they count
/// as right: parts of the step would find none better.
void RestEngine::keep_loads(Group& group, double time)
{
    const std::span<ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const auto complaint = [&] {
        set_free(group, time);
        warm_start(points, movers_);
        return worst_complaint(points, movers_);
    };
    const double after = complaint();
    load_points_.assign(points.begin(), points.end());
    for (ContactPoint& c : points) recall_load(c);
    const double before = complaint();
    const bool any = std::any_of(points.begin(), points.end(), [](const ContactPoint& c) { return c.normal > 0.0; });
    group.is_content = any && std::min(before, after) <= k_slight * field_speed(group);
    if (before <= k_much_better * after) return;
    std::copy(load_points_.begin(), load_points_.end(), points.begin());
    (void)complaint();
}
// [rest.solve.keep]

// [rest.solve.scales]
double RestEngine::top_speed(const Group& group) const
{
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    return std::max(field_speed(group), greatest_speed(before_, radius_, members));
}

double RestEngine::field_speed(const Group& group) const
{
    double top = 0.0;
    for (int k = 0; k < group.member_count; ++k) {
        const Vec2& g = field_[members_[group.first_member + k]];
        top = std::max({top, std::abs(g.x()), std::abs(g.y())});
    }
    return span_ * top;
}
// [rest.solve.scales]

// [rest.bounds]
bool RestEngine::set_bounds(Group& group)
{
    const double field = field_speed(group);
    bool any_bounce = false;
    for (int k = 0; k < group.point_count; ++k) {
        ContactPoint& c = points_[group.first_point + k];
        const double fall = fall_of(c);
        const double moment = span_ - c.left;
        const double u = normal_speed(c, before_[c.a], before_[c.b]) + moment * fall;
        const double touch = touch_gap(c.a, c.b);
        const double gap = c.gap > touch ? c.gap : 0.0;
        c.impact = 0.0;

        // [rest.bounds.later]
        // What parts, or is not there yet, may come as near as to touch at the end. What gets there just then, as where
        // the step was parted at that moment, bears nothing on the way
        c.bound = std::min(0.0, -2.0 * (gap > 0.0 ? gap + 0.5 * touch : 0.0) / c.left - u);
        if (gap > 0.0 || u >= 0.0) continue;
        // [rest.bounds.later]

        // [rest.bounds.thrown]
        // What arrives is thrown back, unless its load would bring it down again before
        // the step ends: that includes the weight that something else bears until then
        const double rebound = -c.restitution * u;
        const double back = std::min(fall, weight_of(c));
        const bool loaded = 2.0 * rebound * c.normal_mass <= c.normal;
        const bool falls_back = back < 0.0 && 2.0 * rebound <= -back * (c.left + after_);
        const bool too_slow = is_crowd(group) && 2.0 * rebound <= field;
        const bool rests = loaded || falls_back || too_slow;
        c.bound = rests ? 0.0 : rebound + back * c.left;
        c.impact = c.normal_mass * (rests ? -u : rebound - u);
        any_bounce = any_bounce || !rests;
        if (!rests) ++counts_.impacts;
        // [rest.bounds.thrown]
    }

    // Where bodies are thrown back in this step, gaps that they may close are left to the next: it throws back by the
    // speed that they have then
    if (!any_bounce) return false;
    left_out_.clear();
    const auto begin = points_.begin() + group.first_point;
    auto end = begin;
    for (auto c = begin; c != begin + group.point_count; ++c) {
        const bool may_close = c->restitution > 0.0 && c->normal == 0.0 && c->gap > touch_gap(c->a, c->b);
        if (may_close) left_out_.push_back(*c);
        else *end++ = *c;
    }
    std::copy(left_out_.begin(), left_out_.end(), end);
    group.point_count = static_cast<int>(end - begin);
    return true;
}
// [rest.bounds]

// [rest.calm.rounding]
/// Speeds that the impulses' rounding explains.  [m/s]
double RestEngine::solve_rounding(const Group& group) const
{
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    return rest_tolerance::k_stagnant * rounding_of(points, group.member_count);
}

/// Below what the field gives in a step by many orders, motion is the solve's rounding.  [m/s]
double RestEngine::still_speed(const Group& group) const
{
    // [rest.calm.still]
    return rest_tolerance::k_still * field_speed(group) + solve_rounding(group);
    // [rest.calm.still]
}
// [rest.calm.rounding]

// [rest.calm]
void RestEngine::calm(const Group& group)
{
    const double rounding = solve_rounding(group);
    const double still = still_speed(group);
    bool all_still = true;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const Mover& mover = movers_[member];
        const double turn = std::abs(mover.spin) * radius_[member];
        const double speed = std::max({std::abs(mover.v_x), std::abs(mover.v_y), turn});
        all_still = all_still && speed <= still;
    }

    // Whoever slides on a level floor neither sinks nor turns, where the solve could not tell what it does from nothing
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        Mover& mover = movers_[member];
        const double top = std::max(std::abs(mover.v_x), std::abs(mover.v_y));
        const double limit = all_still ? still : std::min(rounding, rest_tolerance::k_still * top);
        if (std::abs(mover.v_x) <= limit) mover.v_x = 0.0;
        if (std::abs(mover.v_y) <= limit) mover.v_y = 0.0;
        if (std::abs(mover.spin) * radius_[member] <= limit) mover.spin = 0.0;
    }
}
// [rest.calm]

} // namespace flying
