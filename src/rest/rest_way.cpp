#include "rest/rest_way.hpp"

#include <algorithm>
#include <cmath>

#include "rest/rest_engine.hpp"

namespace flying {
namespace {

// [rest.way.few]
/// [of a leg] The rest of a part after an impact says nothing about velocities where it is shorter.
constexpr double k_telling = 0x1p-20;
// [rest.way.few]

// [rest.way.cubic]
/// The number at a share s of a leg that grows by `way` in all: the cubic with the slopes of its ends, for a whole leg.
[[nodiscard]] double cubic(double s, double way, double slope_start, double slope_end)
{
    const double t = 1.0 - s;
    return s * s * (3.0 - 2.0 * s) * way + s * t * (t * slope_start - s * slope_end);
}

/// Its slope.
[[nodiscard]] double slope(double s, double way, double slope_start, double slope_end)
{
    const double t = 1.0 - s;
    return 6.0 * s * t * way + t * (1.0 - 3.0 * s) * slope_start + s * (3.0 * s - 2.0) * slope_end;
}
// [rest.way.cubic]

} // namespace

// [rest.way.along]
BodyState along(const std::vector<Leg>& legs, double time)
{
    // Find the leg; what rounding leaves beyond the last belongs to it
    std::size_t k = 0;
    double before = 0.0;
    while (k + 1 < legs.size() && before + legs[k].length <= time) before += legs[k++].length;
    const Leg& leg = legs[k];
    const double h = leg.length;
    const double s = h > 0.0 ? std::clamp((time - before) / h, 0.0, 1.0) : 1.0;
    BodyState state = leg.start;
    if (leg.kind == Leg::Kind::even) {
        state.position += s * leg.shift;
        state.angle += s * leg.turn;
    } else {
        state.position += Vec2(cubic(s, leg.shift.x(), h * leg.start.velocity.x(), h * leg.velocity.x()),
                               cubic(s, leg.shift.y(), h * leg.start.velocity.y(), h * leg.velocity.y()));
        state.angle += cubic(s, leg.turn, h * leg.start.spin, h * leg.spin);
    }
    if (leg.kind == Leg::Kind::curved && h > 0.0) {
        state.velocity = Vec2(slope(s, leg.shift.x(), h * leg.start.velocity.x(), h * leg.velocity.x()),
                              slope(s, leg.shift.y(), h * leg.start.velocity.y(), h * leg.velocity.y())) / h;
        state.spin = slope(s, leg.turn, h * leg.start.spin, h * leg.spin) / h;
    } else {
        state.velocity = leg.start.velocity + s * (leg.velocity - leg.start.velocity);
        state.spin = leg.start.spin + s * (leg.spin - leg.start.spin);
    }
    return state;
}
// [rest.way.along]

// [rest.way.note]
/// Write down how a group goes through a step, or a part of one, that has been found but not yet gone.
void RestEngine::note_legs(const Group& group)
{
    if (!legs_) return;
    double strikes = 0.0; // when: all impacts of a group that is not parted have one moment
    bool any_strikes = false;
    for (const ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        if (!is_struck(c)) continue;
        strikes = any_strikes ? std::min(strikes, span_ - c.left) : span_ - c.left;
        any_strikes = true;
    }
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        std::vector<Leg>& legs = (*legs_)[order_[member]];
        const Mover& end = movers_[member];
        Leg leg{span_, bodies_[member].state, shift_[member], turn_[member], Vec2(end.v_x, end.v_y), end.spin,
                Leg::Kind::bent};
        if (!group.is_exact) leg.kind = Leg::Kind::even;
        else if (group.has_ways) leg.kind = Leg::Kind::curved;
        if (!group.is_exact || !any_strikes) {
            legs.push_back(leg);
            continue;
        }

        // Until the impact all went on as expected; from there on the velocity is what leads to the end
        const BodyState from = leg.start;
        const double left = span_ - strikes;
        leg.start.position = place_at(member, strikes);
        leg.start.angle = from.angle + strikes * (from.spin + 0.5 * strikes * turn_pull_[member]);
        if (strikes > 0.0) {
            legs.push_back({strikes, from, leg.start.position - from.position, leg.start.angle - from.angle,
                            from.velocity + strikes * pull_[member], from.spin + strikes * turn_pull_[member],
                            Leg::Kind::bent});
        }
        leg.length = left;
        leg.shift = (from.position + shift_[member]) - leg.start.position;
        leg.turn = (from.angle + turn_[member]) - leg.start.angle;
        const bool tells = left > k_telling * span_;
        leg.start.velocity = tells ? Vec2(2.0 * leg.shift / left - leg.velocity) : leg.velocity;
        leg.start.spin = tells ? 2.0 * leg.turn / left - leg.spin : leg.spin;
        legs.push_back(leg);
    }
}

/// The legs that were noted belong to a step that is made anew.
void RestEngine::forget_legs()
{
    if (!legs_) return;
    for (std::vector<Leg>& legs : *legs_) legs.clear();
}
// [rest.way.note]

// [rest.way.foresee]
std::vector<std::vector<Leg>> RestEngine::foresee(double length, double end)
{
    const Memory before = memory();
    const RestCounts counts = counts_;
    const std::int64_t sleepers = sleepers_;
    std::vector<std::vector<Leg>> legs(bodies_.size());
    legs_ = &legs;
    step_by(length, end);
    legs_ = nullptr;
    go_on_from(before);
    counts_ = counts;
    sleepers_ = sleepers;
    return legs;
}
// [rest.way.foresee]

} // namespace flying
