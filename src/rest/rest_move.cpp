#include <algorithm>
#include <cmath>
#include <utility>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

// [rest.move.load]
/// What a point bore beyond its impact.  [N s]
[[nodiscard]] double load_of(const ContactPoint& c)
{
    const double rest = c.normal - std::min(c.impact, c.normal);
    return rest > rest_tolerance::k_load * c.normal ? rest : 0.0;
}
// [rest.move.load]

} // namespace

// [rest.move.expect]
void RestEngine::expect_same(int body)
{
    const Mover& old = before_[body];
    const Mover& now = movers_[body];
    pull_[body] = Vec2(now.v_x - old.v_x, now.v_y - old.v_y) / span_;
    turn_pull_[body] = (now.spin - old.spin) / span_;
}

void RestEngine::expect(const Group& group)
{
    // Bodies that bear a load will do what they did in this step; but those that were struck what their loads make them do
    borne_.resize(bodies_.size(), 0);
    struck_.resize(bodies_.size(), 0);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    bool any_struck = false;
    for (const ContactPoint& c : points) {
        if (c.normal == 0.0) continue;
        const bool is_blow = is_struck(c);
        any_struck = any_struck || is_blow;
        std::vector<char>& marks = is_blow ? struck_ : borne_;
        if (is_moved(c.a)) marks[c.a] = 1;
        if (is_moved(c.b)) marks[c.b] = 1;
    }
    for (const int member : members) {
        if (borne_[member] && !struck_[member]) expect_same(member);
        else expect_flight(member, bodies_[member].state.position + shift_[member]);
    }

    // Without a field no load outlasts a blow
    const bool any_loads = any_struck && group.knows_loads && field_speed(group) > 0.0;
    if (any_loads) expect_loads(points);
    for (const int member : members) borne_[member] = struck_[member] = 0;
}

/// Of those that were struck.
void RestEngine::expect_loads(std::span<const ContactPoint> points)
{
    for (const ContactPoint& c : points) {
        if (!struck_[c.a] && !struck_[c.b]) continue;
        const double load = load_of(c);
        if (load == 0.0) continue;
        Mover a{0.0, 0.0, 0.0, movers_[c.a].inv_mass, movers_[c.a].inv_moment};
        Mover b{0.0, 0.0, 0.0, movers_[c.b].inv_mass, movers_[c.b].inv_moment};
        push(c, load / c.left, c.tangent * (load / c.normal) / c.left, a, b);
        for (const auto& [body, gain] : {std::pair(c.a, a), std::pair(c.b, b)}) {
            if (!struck_[body]) continue;
            pull_[body] += Vec2(gain.v_x, gain.v_y);
            turn_pull_[body] += gain.spin;
        }
    }
}
// [rest.move.expect]

// [rest.places]
void RestEngine::find_places(const Group& group)
{
    if (group.has_ways) return;

    // An impact has changed the velocity from its moment on, and not half the step long
    const double dt = span_;
    for (int k = 0; k < group.point_count; ++k) {
        const ContactPoint& c = points_[group.first_point + k];
        const double impact = std::min(c.impact, c.normal);
        const double place = impact * (c.left - 0.5 * dt) + load_of(c) * (0.5 * (c.left - dt));
        if (place == 0.0) continue;
        Mover a{0.0, 0.0, 0.0, movers_[c.a].inv_mass, movers_[c.a].inv_moment};
        Mover b{0.0, 0.0, 0.0, movers_[c.b].inv_mass, movers_[c.b].inv_moment};
        push(c, place, c.tangent * (place / c.normal), a, b);
        shift_[c.a] += Vec2(a.v_x, a.v_y);
        turn_[c.a] += a.spin;
        shift_[c.b] += Vec2(b.v_x, b.v_y);
        turn_[c.b] += b.spin;
    }

    // [rest.places.mean]
    // For the rest, places move by the mean of the velocities before and after
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const Mover& old = before_[member];
        const Mover& now = movers_[member];
        const Vec2 mean(0.5 * (old.v_x + now.v_x), 0.5 * (old.v_y + now.v_y));
        shift_[member] += dt * mean;
        turn_[member] += dt * (0.5 * (old.spin + now.spin));
    }
    // [rest.places.mean]
}
// [rest.places]

// [rest.move]
/// A body had no motion when the step began either, and what is expected of it now was expected then.
bool RestEngine::stood_alike(int member) const
{
    const Saved& old = saved_[member];
    return old.state.velocity.isZero(0.0) && old.state.spin == 0.0 && old.pull == pull_[member] &&
           old.turn_pull == turn_pull_[member] && old.in_crowd == in_crowd_[member];
}

void RestEngine::move_group(const Group& group)
{
    note_legs(group);

    // Remember what the points bore
    bool same = true;
    for (int k = 0; k < group.point_count; ++k) {
        const ContactPoint& c = points_[group.first_point + k];
        RestPair& pair = pairs_.pairs()[c.pair];
        const double load = load_of(c);
        const double share = c.normal > 0.0 ? load / c.normal : 0.0;
        const double tangent = c.tangent * share;
        for (int i = 0; i < pair.count; ++i) {
            if (pair.feature[i] != c.feature) continue;
            same = same && pair.normal[i] == load && pair.tangent[i] == tangent;
            pair.normal[i] = load;
            pair.tangent[i] = tangent;
        }
    }

    expect(group);

    // Move
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        in_crowd_[member] = is_crowd(group) ? 1 : 0;
        BodyState& state = bodies_[member].state;
        const Mover& now = movers_[member];
        const Vec2& way = shift_[member];
        same = same && way.x() == 0.0 && way.y() == 0.0 && turn_[member] == 0.0 && now.v_x == 0.0 && now.v_y == 0.0 &&
               now.spin == 0.0 && stood_alike(member);
        state.position += way;
        state.angle += turn_[member];
        state.velocity = Vec2(now.v_x, now.v_y);
        state.spin = now.spin;
        state.time = time() + options_.step;
    }

    // What a whole step leaves as it was, the next leaves too
    same = same && span_ == options_.step;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        still_[member] = same ? 1 : 0;
        if (same && options_.sleeps) {
            asleep_[member] = 1;
            sleep_group_[member] = members_[group.first_member];
        }
    }
}
// [rest.move]

} // namespace flying
