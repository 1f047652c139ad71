#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

} // namespace

// [rest.swept]
/// A group too large to be solved whole: each step goes on with the sweeps of the last.
void RestEngine::sweep_large(Group& group)
{
    group.is_exact = false;
    const std::span<ContactPoint> points = group.points;
    const std::span<const int> members = group.members;
    const double field = field_speed(group);
    const double before = greatest_speed(motion_.before, bodies_.radius, members);
    bound_swept(group, before <= rest_tolerance::k_calm * field);
    set_free(group, motion_.span);
    GroupSolver::SweepPlan plan;
    plan.sweeps = options_.sweeps;
    plan.looks_ahead = true;
    plan.most_sweeps = options_.most_sweeps;
    plan.enough = rest_tolerance::k_enough * energy_of_fall(group);
    plan.far_from_closing = rest_tolerance::k_far * std::max(before, field);
    plan.time = motion_.span;
    plan.tolerance = rest_tolerance::k_content_enough * rest_tolerance::k_calm * field;
    if (before > rest_tolerance::k_slow_heap * field) {
        plan.push_sweeps = options_.push_sweeps;
        plan.push_share = rest_tolerance::k_push_share;
    }
    solver_.sweep_group(motion_.now, members, points, plan, place_movers_);
    if (group.member_count <= rest_tolerance::k_most_swept_on) {
        const double most = before > rest_tolerance::k_slow_heap * field ? rest_tolerance::k_fair_approach
                                                                         : rest_tolerance::k_slow_approach;
        const double left = approaches_left(points);
        if (left > most) end_approaches_whole(group, plan, std::max(most, rest_tolerance::k_gets_on * left));
    }

    // What hardly moves comes to rest
    const double after = greatest_speed(motion_.now, bodies_.radius, members);
    if (before <= rest_tolerance::k_calm * field && after <= rest_tolerance::k_calm * field) {
        for (const int member : members) {
            Mover& mover = motion_.now[member];
            mover.v_x = mover.v_y = mover.spin = 0.0;
            place_movers_[member] = mover;
        }
    }
    bear_less(group);
    move_as_swept(group);
}
// [rest.swept]

// [rest.swept.approaches]
/// How much deeper points come to overlap in the step than they may.  [sizes]
double RestEngine::approaches_left(std::span<const ContactPoint> points) const
{
    double worst = 0.0;
    for (const ContactPoint& c : points) {
        const double missed = motion_.span * (c.bound - normal_speed(c, motion_.now[c.a], motion_.now[c.b]));
        worst = std::max(worst, missed / std::min(bodies_.radius[c.a], bodies_.radius[c.b]));
    }
    return worst;
}

/// Sweeps take the longer the more masses differ: what they leave is swept on, and what that leaves is solved whole.
void RestEngine::end_approaches_whole(const Group& group, GroupSolver::SweepPlan plan, double most)
{
    const std::span<ContactPoint> points = group.points;
    const std::span<const int> members = group.members;
    plan.sweeps = plan.most_sweeps = rest_tolerance::k_more_sweeps;
    plan.tolerance = 0.0;
    set_free(group, motion_.span);
    solver_.sweep_group(motion_.now, members, points, plan, place_movers_);
    if (approaches_left(points) <= most) return;
    set_free(group, motion_.span);
    solver_.solve(motion_.now, members, points, rest_tolerance::k_content * top_speed(group));
    for (const int member : members) place_movers_[member] = motion_.now[member];
}
// [rest.swept.approaches]

// [rest.swept.scales]
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

/// What free fall through one step brings, from rest, twice over; infinite without a field, where nothing presses on.
double RestEngine::energy_of_fall(const Group& group) const
{
    double sum = 0.0;
    for (const int member : group.members) {
        sum += (motion_.span * motion_.field[member]).squaredNorm() / motion_.now[member].inv_mass;
    }
    return sum > 0.0 ? sum : std::numeric_limits<double>::infinity();
}
// [rest.swept.scales]

// [rest.swept.less]
/// Sweeps that go on from what bore too much lift a heap. With no impulses it would fall through the step, and lose
/// energy by that; with some share of them it neither gains nor loses any.
void RestEngine::bear_less(const Group& group)
{
    // [rest.swept.less.share]
    // With a share s of the impulses the energy grows by  square s^2 + linear s + constant
    double square = 0.0;   // [J]
    double linear = 0.0;   // [J]
    double constant = 0.0; // [J]
    double before = 0.0;
    const std::span<const int> members = group.members;
    for (const int member : members) {
        const Mover& old = motion_.before[member];
        const Mover& now = motion_.now[member];
        const Vec2 velocity(old.v_x, old.v_y);
        const Vec2 fall = motion_.span * motion_.field[member];
        const Vec2 change = Vec2(now.v_x, now.v_y) - velocity - fall;
        const double spin = now.spin - old.spin;
        square += 0.5 * (change.squaredNorm() / now.inv_mass + spin * spin / now.inv_moment);
        linear += velocity.dot(change) / now.inv_mass + old.spin * spin / now.inv_moment;
        constant -= 0.5 * fall.squaredNorm() / now.inv_mass;
        before += 0.5 * (velocity.squaredNorm() / now.inv_mass + old.spin * old.spin / now.inv_moment);
    }
    const double scale = before + square - constant;
    if (!(square + linear + constant > rest_tolerance::k_rounding * scale)) return;
    const double root = std::sqrt(linear * linear - 4.0 * square * constant);
    const double share = linear > 0.0 ? -2.0 * constant / (linear + root) : (root - linear) / (2.0 * square);
    // [rest.swept.less.share]

    for (ContactPoint& c : group.points) {
        c.normal *= share;
        c.tangent *= share;
    }
    for (const int member : members) {
        const Mover& old = motion_.before[member];
        const Vec2 fall = motion_.span * motion_.field[member];
        Mover& now = motion_.now[member];
        Mover& pushed = place_movers_[member];
        const Mover all = now;
        now.v_x = (old.v_x + fall.x()) + share * (all.v_x - (old.v_x + fall.x()));
        now.v_y = (old.v_y + fall.y()) + share * (all.v_y - (old.v_y + fall.y()));
        now.spin = old.spin + share * (all.spin - old.spin);
        pushed.v_x += now.v_x - all.v_x;
        pushed.v_y += now.v_y - all.v_y;
        pushed.spin += now.spin - all.spin;
    }
}
// [rest.swept.less]

// [rest.swept.move]
void RestEngine::move_as_swept(const Group& group)
{
    const std::span<const int> members = group.members;
    double lift = 0.0; // work against the field, of what pushes overlap apart [J]
    for (const int member : members) {
        const Mover& now = motion_.now[member];
        motion_.shift[member] = motion_.span * Vec2(now.v_x, now.v_y);
        motion_.turn[member] = motion_.span * now.spin;
        lift -= motion_.span * motion_.field[member].dot(push_of(member)) / now.inv_mass;
    }

    // It may cost no more energy than the sweeps have taken
    const double share = lift > 0.0 ? std::clamp(-gain_of(group).gained / lift, 0.0, 1.0) : 1.0;
    for (const int member : members) {
        motion_.shift[member] += (motion_.span * share) * push_of(member);
        motion_.turn[member] += (motion_.span * share) * (place_movers_[member].spin - motion_.now[member].spin);
    }
}

/// By which a body's place moves beyond its velocity.  [m/s]
Vec2 RestEngine::push_of(int member) const
{
    const Mover& now = motion_.now[member];
    const Mover& pushed = place_movers_[member];
    return Vec2(pushed.v_x - now.v_x, pushed.v_y - now.v_y);
}
// [rest.swept.move]

// [rest.swept.bounds]
void RestEngine::bound_swept(const Group& group, bool is_calm)
{
    const double field = field_speed(group);
    for (ContactPoint& c : group.points) {
        // All of a gap passes with the velocities that the step ends with. In a calm group nothing comes to close one:
        // what bears over a gap that a calm speed would close goes on to bear, or its load would wane for minutes
        c.bound = -std::max(c.gap, 0.0) / motion_.span;
        if (is_calm && c.normal > 0.0 && -c.bound <= rest_tolerance::k_calm * field) c.bound = 0.0;
    }
}
// [rest.swept.bounds]

// [rest.swept.heap]
/// Sweeps over what the direct solve rarely finds where a heap moves, for all its factorisations.
///
/// tolerance  where no point asks for a greater change, impulses stay as they are; below 0 they never do [m/s]
void RestEngine::sweep_heap(const Group& group, std::span<Mover> movers, std::span<ContactPoint> points,
                            double tolerance)
{
    const std::span<const int> members = group.members;
    GroupSolver::SweepPlan plan;
    plan.sweeps = rest_tolerance::k_heap_sweeps;
    plan.looks_ahead = true;
    plan.tolerance = tolerance;
    part_movers_.resize(motion_.now.size());
    solver_.sweep_group(movers, members, points, plan, part_movers_);
}
// [rest.swept.heap]

} // namespace flying
