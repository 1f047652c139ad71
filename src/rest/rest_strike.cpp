#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/impact.hpp"
#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {


/// Bodies of the largest island whose impacts have moments of their own; in larger ones all that a step brings come at its
/// start.
constexpr int k_most_in_turn = 12;


} // namespace


bool RestEngine::strikes_at_start(const Group& group)
{
    return group.member_count > k_most_in_turn;
}

/// An approach that the field alone would bring about in a small part of the step is left to the load, but where nothing may
/// be lost.  [m/s]
double RestEngine::slowest_blow(const Group& group) const
{
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const bool is_elastic =
        std::any_of(points.begin(), points.end(), [](const ContactPoint& c) { return c.restitution == 1.0; });
    const double by_field = is_elastic ? 0.0 : rest_tolerance::k_blow * field_speed(group);
    return by_field + solve_rounding(group) + rest_tolerance::k_stagnant * rest_tolerance::k_content * top_speed(group);
}

/// A gap this small isn't worth a moment of its own, unless it closes fast.  [m]
double RestEngine::hardly_open(const ContactPoint& c) const
{
    return rest_tolerance::k_closed * std::min(radius_[c.a], radius_[c.b]);
}

/// The moment of the first impact after the beginning; 0 where there is none.  [s]
double RestEngine::first_impact(const Group& group) const
{
    const double slowest = slowest_blow(group);
    double first = span_;
    for (const ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        if (c.closes_at > rest_tolerance::k_at_once * span_ && c.closing_speed > slowest) first = std::min(first, c.closes_at);
    }
    return first < span_ ? first : 0.0;
}

/// When an impact comes that was not foreseen, since bodies sped up otherwise than they did before: the first moment at which
/// a gap closes on the ways that were found; 0 where none does.  [s]
double RestEngine::missed_impact(const Group& group) const
{
    double first = span_;
    for (const ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        if (!std::isinf(c.bound)) continue;
        const double way = c.n_x * (shift_[c.b].x() - shift_[c.a].x()) + c.n_y * (shift_[c.b].y() - shift_[c.a].y()) +
                           (turn_[c.b] * c.normal_arm_b - turn_[c.a] * c.normal_arm_a);
        if (c.gap + way < -hardly_open(c)) first = std::min(first, span_ * (c.gap / -way));
    }
    return first < span_ ? std::max(first, rest_tolerance::k_at_once * span_) : 0.0;
}



/// A rebound that would come back within the rest of the step doesn't happen, but for one that loses nothing: the slowest
/// approach that brings a rebound.  [m/s]
double RestEngine::slowest_rebound(const ContactPoint& c) const
{
    if (c.restitution == 1.0) return 0.0;
    if (c.restitution == 0.0) return std::numeric_limits<double>::infinity();
    const double by_load = c.normal / c.normal_mass;
    const double by_fall = -std::min(fall_of(c), weight_of(c)) * (span_ + after_);
    return std::max({by_load, by_fall, 0.0}) / (2.0 * c.restitution);
}



/// Impacts of an island, at the moment at which the step, or the part of one, begins: first those that throw back, then the
/// rest of the approaches, all at once and without rebound. True where there were any; `before_` is what they leave.
/// Where impacts have no moments of their own, all that closes within the step counts as closed.
bool RestEngine::strike(const Group& group)
{
    // Find what is closed, or closes
    const double slowest = slowest_blow(group);
    struck_.clear();
    slowest_.clear();
    bool any = false;
    const double within = group.in_turn ? rest_tolerance::k_at_once * span_ : span_;
    for (const ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        const double u = normal_speed(c, before_[c.a], before_[c.b]);
        if (c.gap > touch_gap(c.a, c.b) && c.gap + within * u > 0.0) continue;
        any = any || u < -slowest;
        struck_.push_back(c);
        slowest_.push_back(std::max(slowest, slowest_rebound(c)));
        struck_.back().bound = struck_.back().normal = struck_.back().tangent = 0.0;
    }
    if (!any) return false;

    counts_.impacts += throw_back(before_, struck_, slowest_);
    const auto approaches = [&](const ContactPoint& c) { return normal_speed(c, before_[c.a], before_[c.b]) < -slowest; };
    if (std::any_of(struck_.begin(), struck_.end(), approaches)) end_approaches(group);
    if (!group.in_turn) return true;
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        const Mover& now = before_[member];
        BodyState& state = bodies_[member].state;
        if (state.velocity == Vec2(now.v_x, now.v_y) && state.spin == now.spin) continue;
        state.velocity = Vec2(now.v_x, now.v_y);
        state.spin = now.spin;
        expect_flight(member, state.position); // what it bore before tells nothing any more
    }
    return true;
}

void RestEngine::end_approaches(const Group& group)
{
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    if (is_heap(group)) sweep_heap(group, before_, struck_);
    else solver_.solve(before_, members, struck_, rest_tolerance::k_content * top_speed(group));
}


} // namespace flying
