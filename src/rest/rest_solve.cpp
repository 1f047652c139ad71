#include <algorithm>
#include <cmath>
#include <limits>

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



void RestEngine::solve_group(Group& group, int depth)
{
    if (group.point_count == 0) {
        fly(group);
        return;
    }
    // End the part where the first impact comes, or strike now; small islands go on from there with another look
    group.in_turn = !strikes_at_start(group) && may_be_cut(group, depth);
    if (group.in_turn) group.cut_at = first_impact(group);
    if (group.cut_at > 0.0) return;
    if (strike(group) && group.in_turn) {
        group.cut_at = span_;
        return;
    }

    // Find the forces of the contacts
    group.is_exact = is_solved_whole(group);
    if (!group.is_exact) {
        sweep_large(group);
        return;
    }
    set_bounds(group);
    const bool leans = is_heap(group);
    if (leans && top_speed(group) > k_standing * field_speed(group)) {
        sweep_large(group);
        return;
    }
    find_impulses(group, span_);
    if (leans && !group.is_content) {
        // It would cost more than it brings to look on; sweeps go on from what bore before
        for (ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) recall_load(c);
        sweep_large(group);
        return;
    }
    if (!follow_curves(group) && group.point_count <= k_most_parted) part_where_slip_ends(group);
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



/// What bears goes on to bear. What is apart may come as near as to touch when the step ends; where impacts have moments of
/// their own only what is all but closed is held like that, since the step ends where anything else closes.
void RestEngine::set_bounds(const Group& group)
{
    for (ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        const double u = normal_speed(c, before_[c.a], before_[c.b]);
        const double gap = c.gap > touch_gap(c.a, c.b) ? c.gap : 0.0;
        c.bound = std::min(0.0, -2.0 * gap / span_ - u);
        if (group.in_turn && gap > hardly_open(c)) c.bound = -std::numeric_limits<double>::infinity();
    }
}

/// What a point bore at the end of the step before.
void RestEngine::recall_load(ContactPoint& c) const
{
    const RestPair& pair = pairs_.pairs()[c.pair];
    c.normal = c.tangent = 0.0;
    for (int i = 0; i < pair.count; ++i) {
        if (pair.feature[i] != c.feature) continue;
        c.normal = pair.normal[i];
        c.tangent = pair.tangent[i];
    }
}



/// Speeds that the impulses' rounding explains.  [m/s]
double RestEngine::solve_rounding(const Group& group) const
{
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    return rest_tolerance::k_stagnant * rounding_of(points, group.member_count);
}

/// Below what the field gives in a step by many orders, motion is the solve's rounding.  [m/s]
double RestEngine::still_speed(const Group& group) const
{

    return rest_tolerance::k_still * field_speed(group) + solve_rounding(group);

}



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


} // namespace flying
