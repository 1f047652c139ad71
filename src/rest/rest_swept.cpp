#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {


/// [speeds that the field gives in a step] A group that was slower and stays so is at rest: what it was about to do is
/// the price of its sleep. Its bodies would speed up by twice as much of the field's acceleration at most.
constexpr double k_calm = 0x1p-8;
/// [k_calm] Where no point asks for a greater change, impulses stay as they are, to the bit.
constexpr double k_content_enough = 0x1p-2;
/// [speeds that the field gives in a step] In slower groups nothing is pushed apart any more: that would shake them.
constexpr double k_slow = 4.0;
/// [greatest speeds] Points that would have to close faster than that wait for the end of the sweeps.
constexpr double k_far = 2.0;
/// [energies of fall] What a sweep's changes are worth when there are enough of them.
constexpr double k_enough = 0x1p-10;
/// [sizes] Overlap that sweeps may add in one step, and in one of a group that is slow.
constexpr double k_fair_approach = 0x1p-10;
constexpr double k_slow_approach = 0x1p-13;
/// Sweeps that go on where more is left, and bodies of the largest group that is worth them.
constexpr int k_more_sweeps = 128;
constexpr int k_most_swept_on = 1024;
/// [approaches left] Sweeps that leave more don't get on.
constexpr double k_gets_on = 0.25;
/// Share of an overlap that one step takes off.
constexpr double k_push_share = 0.25;
/// Sweeps that end the impacts of a heap, and that push its overlap apart.
constexpr int k_heap_sweeps = 16;


} // namespace


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
    plan.most_sweeps = options_.most_sweeps;
    plan.enough = k_enough * energy_of_fall(group);
    plan.far_from_closing = k_far * std::max(before, field);
    plan.time = span_;
    plan.tolerance = k_content_enough * k_calm * field;
    if (before > k_slow * field) {
        plan.push_sweeps = options_.push_sweeps;
        plan.push_share = k_push_share;
    }
    solver_.sweep_group(movers_, members, points, plan, place_movers_);
    if (group.member_count <= k_most_swept_on) {
        const double most = before > k_slow * field ? k_fair_approach : k_slow_approach;
        const double left = approaches_left(points);
        if (left > most) end_approaches_whole(group, plan, std::max(most, k_gets_on * left));
    }

    // What hardly moves comes to rest
    const double after = greatest_speed(movers_, radius_, members);
    if (before <= k_calm * field && after <= k_calm * field) {
        for (const int member : members) {
            Mover& mover = movers_[member];
            mover.v_x = mover.v_y = mover.spin = 0.0;
            place_movers_[member] = mover;
        }
    }
    bear_less(group);
    move_as_swept(group);
}



/// How much deeper points come to overlap in the step than they may.  [sizes]
double RestEngine::approaches_left(std::span<const ContactPoint> points) const
{
    double worst = 0.0;
    for (const ContactPoint& c : points) {
        const double missed = span_ * (c.bound - normal_speed(c, movers_[c.a], movers_[c.b]));
        worst = std::max(worst, missed / std::min(radius_[c.a], radius_[c.b]));
    }
    return worst;
}

/// Sweeps take the longer the more masses differ: what they leave is swept on, and what that leaves is solved whole.
void RestEngine::end_approaches_whole(const Group& group, GroupSolver::SweepPlan plan, double most)
{
    const std::span<ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    plan.sweeps = plan.most_sweeps = k_more_sweeps;
    plan.tolerance = 0.0;
    set_free(group, span_);
    solver_.sweep_group(movers_, members, points, plan, place_movers_);
    if (approaches_left(points) <= most) return;
    set_free(group, span_);
    solver_.solve(movers_, members, points, rest_tolerance::k_content * top_speed(group));
    for (const int member : members) place_movers_[member] = movers_[member];
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

/// What free fall through one step brings, from rest, twice over; infinite without a field, where nothing presses on.
double RestEngine::energy_of_fall(const Group& group) const
{
    double sum = 0.0;
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        sum += (span_ * field_[member]).squaredNorm() / movers_[member].inv_mass;
    }
    return sum > 0.0 ? sum : std::numeric_limits<double>::infinity();
}



/// Sweeps that go on from what bore too much lift a heap. With no impulses it would fall through the step, and lose
/// energy by that; with some share of them it neither gains nor loses any.
void RestEngine::bear_less(const Group& group)
{

    // With a share s of the impulses the energy grows by  square s^2 + linear s + constant
    double square = 0.0;   // [J]
    double linear = 0.0;   // [J]
    double constant = 0.0; // [J]
    double before = 0.0;
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    for (const int member : members) {
        const Mover& old = before_[member];
        const Mover& now = movers_[member];
        const Vec2 velocity(old.v_x, old.v_y);
        const Vec2 fall = span_ * field_[member];
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


    for (ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        c.normal *= share;
        c.tangent *= share;
    }
    for (const int member : members) {
        const Mover& old = before_[member];
        const Vec2 fall = span_ * field_[member];
        Mover& now = movers_[member];
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



void RestEngine::move_as_swept(const Group& group)
{
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    double lift = 0.0; // work against the field, of what pushes overlap apart [J]
    for (const int member : members) {
        const Mover& now = movers_[member];
        shift_[member] = span_ * Vec2(now.v_x, now.v_y);
        turn_[member] = span_ * now.spin;
        lift -= span_ * field_[member].dot(push_of(member)) / now.inv_mass;
    }

    // It may cost no more energy than the sweeps have taken
    const double share = lift > 0.0 ? std::clamp(-gain_of(group).gained / lift, 0.0, 1.0) : 1.0;
    for (const int member : members) {
        shift_[member] += (span_ * share) * push_of(member);
        turn_[member] += (span_ * share) * (place_movers_[member].spin - movers_[member].spin);
    }
}

/// By which a body's place moves beyond its velocity.  [m/s]
Vec2 RestEngine::push_of(int member) const
{
    const Mover& now = movers_[member];
    const Mover& pushed = place_movers_[member];
    return Vec2(pushed.v_x - now.v_x, pushed.v_y - now.v_y);
}



void RestEngine::bound_swept(const Group& group, bool is_calm)
{
    const double field = field_speed(group);
    for (ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        // All of a gap passes with the velocities that the step ends with. In a calm group nothing comes to close one: what
        // bears over a gap that a calm speed would close goes on to bear, or its load would wane for minutes
        c.bound = -std::max(c.gap, 0.0) / span_;
        if (is_calm && c.normal > 0.0 && -c.bound <= k_calm * field) c.bound = 0.0;
    }
}



/// Sweeps over what the direct solve rarely finds where a heap moves, for all its factorisations.
///
/// tolerance  where no point asks for a greater change, impulses stay as they are; below 0 they never do [m/s]
void RestEngine::sweep_heap(const Group& group, std::span<Mover> movers, std::span<ContactPoint> points, double tolerance)
{
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    GroupSolver::SweepPlan plan;
    plan.sweeps = k_heap_sweeps;
    plan.looks_ahead = true;
    plan.tolerance = tolerance;
    part_movers_.resize(movers_.size());
    solver_.sweep_group(movers, members, points, plan, part_movers_);
}


} // namespace flying
