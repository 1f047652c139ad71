#include <algorithm>
#include <cmath>
#include <utility>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {

void RestEngine::expect_same(int body)
{
    const Mover& old = before_[body];
    const Mover& now = movers_[body];
    pull_[body] = Vec2(now.v_x - old.v_x, now.v_y - old.v_y) / span_;
    turn_pull_[body] = (now.spin - old.spin) / span_;
}

void RestEngine::expect(const Group& group)
{
    // Bodies that bear a load will do what they did in this step
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) expect_flight(member, bodies_[member].state.position + shift_[member]);
    for (const ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        if (c.normal == 0.0) continue;
        if (is_moved(c.a)) expect_same(c.a);
        if (is_moved(c.b)) expect_same(c.b);
    }
}



void RestEngine::find_places(const Group& group)
{
    if (group.has_ways) return;

    // [rest.places.mean]
    // Places move by the mean of the velocities before and after
    const double dt = span_;
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
        for (int i = 0; i < pair.count; ++i) {
            if (pair.feature[i] != c.feature) continue;
            same = same && pair.normal[i] == c.normal && pair.tangent[i] == c.tangent;
            pair.normal[i] = c.normal;
            pair.tangent[i] = c.tangent;
        }
    }

    expect(group);

    // Move
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        in_crowd_[member] = strikes_at_start(group) ? 1 : 0;
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


} // namespace flying
