#include <algorithm>
#include <cmath>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

// [rest.crowd.limits]
/// Bodies of the largest group in which every impact has a moment of its own.
constexpr int k_most_in_turn = 12;
/// Rounds of impacts in one step, where those that end one approach bring another; sweeps of each.
constexpr int k_impact_rounds = 4;
constexpr int k_impact_sweeps = 32;
/// The same in heaps, where they look ahead; and of what the rounds leave, of the load, and of pushes out of overlap.
constexpr int k_heap_impact_sweeps = 8;
constexpr int k_heap_sweeps = 16;
/// Greatest part of the rebound of each point by itself that the rebound of all may be.
constexpr double k_most_share = 2.0;
/// [rounding of speeds] Slower approaches are left to the load.
constexpr double k_approach = 1024.0;
// [rest.crowd.limits]

} // namespace

// [rest.crowd]
bool RestEngine::is_crowd(const Group& group)
{
    return group.member_count > k_most_in_turn;
}

void RestEngine::solve_crowd(Group& group)
{
    group.is_crowd_solved = true;
    group.point_count = group.all_points;
    ++counts_.crowds;
    const std::span<ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    part_movers_.resize(movers_.size());
    impacts_.assign(points.size(), 0.0);
    for (ContactPoint& c : points) {
        // Gaps as they are when the step begins
        const double moment = span_ - c.left;
        const double u = normal_speed(c, before_[c.a], before_[c.b]);
        if (moment > 0.0) c.gap = -moment * (u + 0.5 * moment * fall_of(c));
        if (!(c.gap > touch_gap(c.a, c.b))) c.gap = std::min(c.gap, 0.0);
    }

    // First all impacts of the step, at its start
    for (const int member : members) movers_[member] = before_[member];
    for (int round = 0; round < k_impact_rounds; ++round) {
        if (!end_approaches(group)) break;
    }
    end_all(group);

    // Then the load, from the velocities that they leave, and from what bore before
    for (const int member : members) part_movers_[member] = movers_[member];
    for (ContactPoint& c : points) {
        recall_load(c);
        const double u = normal_speed(c, movers_[c.a], movers_[c.b]);
        c.bound = std::min(0.0, -2.0 * std::max(c.gap, 0.0) / span_ - u);
    }
    parted_ = true;
    find_loads(group);
    parted_ = false;
    for (const int member : members) {
        const Mover& old = part_movers_[member];
        const Mover& now = movers_[member];
        shift_[member] = span_ * Vec2(0.5 * (old.v_x + now.v_x), 0.5 * (old.v_y + now.v_y));
        turn_[member] = span_ * (0.5 * (old.spin + now.spin));
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        ContactPoint& c = points[k];
        const double load = c.normal;
        c.impact = impacts_[k];
        c.normal += c.impact;
        c.left = span_;
        if (load > 0.0) c.tangent *= c.normal / load;
    }
}

void RestEngine::find_loads(Group& group)
{
    if (!is_heap(group)) {
        find_impulses(group, span_);
        return;
    }
    set_free(group, span_);
    sweep_heap(group);
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
// [rest.crowd]

// [rest.crowd.bounds]
/// Bounds that end what closes within the step. True where an approach is left that is more than rounding.
bool RestEngine::bound_approaches(const Group& group)
{
    const double still = k_approach * rest_tolerance::k_content * top_speed(group);
    bool any = false;
    for (int k = 0; k < group.point_count; ++k) {
        ContactPoint& c = points_[group.first_point + k];
        const double u = normal_speed(c, movers_[c.a], movers_[c.b]);
        const double gap = std::max(c.gap, 0.0);
        const bool closes = gap + span_ * u < 0.0;
        c.bound = closes ? 0.0 : -gap / span_;
        c.normal = c.tangent = 0.0;
        any = any || (closes && u < -still);
    }
    return any;
}

/// End, without rebound, what the rounds have left: heavy bodies behind light ones take more sweeps than they have.
void RestEngine::end_all(Group& group)
{
    if (!group.is_exact || !bound_approaches(group)) return;
    const std::span<ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    if (is_heap(group)) sweep_heap(group);
    else solver_.solve(movers_, members, points, rest_tolerance::k_content * top_speed(group));
    for (std::size_t k = 0; k < points.size(); ++k) impacts_[k] += points[k].normal;
}
// [rest.crowd.bounds]

// [rest.crowd.heaps]
/// What all points of a heap push: the direct solve rarely finds it where a heap moves, for all its factorisations.
void RestEngine::sweep_heap(const Group& group)
{
    const std::span<ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    GroupSolver::SweepPlan plan;
    plan.sweeps = k_heap_sweeps;
    plan.looks_ahead = true;
    solver_.sweep_group(movers_, members, points, plan, place_movers_);
}

/// Pushes that take off overlap.
void RestEngine::find_pushes(const Group& group, double tolerance)
{
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    if (!is_heap(group)) {
        solver_.solve(place_movers_, members, place_points_, tolerance);
        return;
    }
    GroupSolver::SweepPlan plan;
    plan.sweeps = k_heap_sweeps;
    plan.looks_ahead = true;
    plan.tolerance = tolerance;
    part_movers_.resize(movers_.size());
    solver_.sweep_group(place_movers_, members, place_points_, plan, part_movers_);
}
// [rest.crowd.heaps]

// [rest.crowd.impacts]
bool RestEngine::end_approaches(const Group& group)
{
    const std::span<ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    if (!bound_approaches(group)) return false;

    // End what closes within the step. Standing still meets these conditions, so that they never contradict each other
    for (const int member : members) part_movers_[member] = movers_[member];
    GroupSolver::SweepPlan plan;
    plan.looks_ahead = is_heap(group);
    plan.sweeps = is_heap(group) ? k_heap_impact_sweeps : k_impact_sweeps;
    solver_.sweep_group(movers_, members, points, plan, place_movers_);

    // Throw back: each point pushes as much again as its restitution says, but where the field alone would end it
    const double field = field_speed(group);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        if (c.normal == 0.0) continue;
        impacts_[k] += c.normal;
        const double u = normal_speed(c, part_movers_[c.a], part_movers_[c.b]);
        if (-2.0 * c.restitution * u <= field) continue;
        push(c, c.restitution * c.normal, 0.0, movers_[c.a], movers_[c.b]);
    }
    share_rebound(members);
    return true;
}

void RestEngine::share_rebound(std::span<const int> members)
{
    // All of the rebound, or as much as there was energy for: what it has is a square function of the share
    double room = 0.0;
    double mixed = 0.0;
    double thrown = 0.0;
    double spent = 0.0;
    for (const int member : members) {
        const Mover& old = part_movers_[member];
        const Mover& now = movers_[member];
        const Mover& ended = place_movers_[member];
        const double d_x = now.v_x - ended.v_x;
        const double d_y = now.v_y - ended.v_y;
        const double d_spin = now.spin - ended.spin;
        const double before = (old.v_x * old.v_x + old.v_y * old.v_y) / old.inv_mass + old.spin * old.spin / old.inv_moment;
        const double after =
            (ended.v_x * ended.v_x + ended.v_y * ended.v_y) / old.inv_mass + ended.spin * ended.spin / old.inv_moment;
        room += 0.5 * (before - after);
        mixed += (ended.v_x * d_x + ended.v_y * d_y) / old.inv_mass + ended.spin * d_spin / old.inv_moment;
        const double e_x = ended.v_x - old.v_x;
        const double e_y = ended.v_y - old.v_y;
        const double e_spin = ended.spin - old.spin;
        spent += 0.5 * ((e_x * e_x + e_y * e_y) / old.inv_mass + e_spin * e_spin / old.inv_moment);
        thrown += 0.5 * ((d_x * d_x + d_y * d_y) / old.inv_mass + d_spin * d_spin / old.inv_moment);
    }
    // What it takes to hold off those that only come near is given back
    const double held_off = mixed < 0.0 ? std::max(room - spent, 0.0) : 0.0;
    const double wanted = std::min(room, thrown + std::max(mixed, 0.0) + held_off);
    const double root = std::sqrt(mixed * mixed + 4.0 * thrown * std::max(wanted, 0.0));
    const double share = wanted > 0.0 && thrown > 0.0 ? std::min((root - mixed) / (2.0 * thrown), k_most_share) : 0.0;
    for (const int member : members) {
        Mover& now = movers_[member];
        const Mover& ended = place_movers_[member];
        now.v_x = ended.v_x + share * (now.v_x - ended.v_x);
        now.v_y = ended.v_y + share * (now.v_y - ended.v_y);
        now.spin = ended.spin + share * (now.spin - ended.spin);
    }
}
// [rest.crowd.impacts]

} // namespace flying
