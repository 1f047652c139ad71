#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/impact.hpp"
#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

// [rest.strike.limits]
/// Bodies of the largest island whose impacts have moments of their own; in larger ones all that a step brings come at its
/// start.
constexpr int k_most_in_turn = 12;
// [rest.strike.limits]

} // namespace

// [rest.strike.when]
bool RestEngine::strikes_at_start(const Group& group)
{
    return group.member_count > k_most_in_turn;
}

/// A slower approach is rounding; or, where impacts have no moments of their own, so small a part of what the field brings in a
/// step that it is left to the load.  [m/s]
double RestEngine::slowest_blow(const Group& group) const
{
    const double by_field = strikes_at_start(group) ? rest_tolerance::k_blow : rest_tolerance::k_still;
    return by_field * field_speed(group) + solve_rounding(group) +
           rest_tolerance::k_stagnant * rest_tolerance::k_content * top_speed(group);
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
// [rest.strike.when]

// [rest.strike.rebound]
/// A rebound that would come back within the rest of the step doesn't happen, but for one that loses nothing: the slowest
/// approach that brings a rebound.  [m/s]
double RestEngine::slowest_rebound(const ContactPoint& c) const
{
    if (c.restitution == 1.0) return 0.0;
    if (c.restitution == 0.0) return std::numeric_limits<double>::infinity();
    const double by_load = c.normal / c.normal_mass;
    const double by_fall = -fall_of(c) * span_;
    return std::max({by_load, by_fall, 0.0}) / (2.0 * c.restitution);
}
// [rest.strike.rebound]

// [rest.strike]
/// Impacts of an island, at the moment at which the step, or the part of one, begins: first those that throw back, then the
/// rest of the approaches, all at once and without rebound. True where there were any; `before_` is what they leave.
///
/// in_turn  only contacts that are closed; else all that close within the step count as closed
bool RestEngine::strike(const Group& group, bool in_turn)
{
    // Find what is closed, or closes
    const double slowest = slowest_blow(group);
    struck_.clear();
    slowest_.clear();
    bool any = false;
    const double within = in_turn ? rest_tolerance::k_at_once * span_ : span_;
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
    if (!in_turn) return true;
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        const Mover& now = before_[member];
        BodyState& state = bodies_[member].state;
        if (state.velocity == Vec2(now.v_x, now.v_y) && state.spin == now.spin) continue;
        state.velocity = Vec2(now.v_x, now.v_y);
        state.spin = now.spin;
        expect_flight(member); // what it bore before tells nothing any more
    }
    return true;
}

void RestEngine::end_approaches(const Group& group)
{
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    if (is_heap(group)) sweep_heap(group, before_, struck_);
    else solver_.solve(before_, members, struck_, rest_tolerance::k_content * top_speed(group));
    ++counts_.impacts;
}
// [rest.strike]

} // namespace flying
