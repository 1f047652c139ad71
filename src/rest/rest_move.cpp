#include <algorithm>
#include <cmath>
#include <utility>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
// [rest.move.expect]
void RestEngine::expect_same(int body)
{
    const Mover& old = motion_.before[body];
    const Mover& now = motion_.now[body];
    motion_.pull[body] = Vec2(now.v_x - old.v_x, now.v_y - old.v_y) / motion_.span;
    motion_.turn_pull[body] = (now.spin - old.spin) / motion_.span;
}

void RestEngine::expect(const Group& group)
{
    // Bodies that bear a load will do what they did in this step
    for (const int member : group.members) expect_flight(member, bodies_.list[member].state.position + motion_.shift[member]);
    for (const ContactPoint& c : group.points) {
        if (c.normal == 0.0) continue;
        if (is_moved(c.a)) expect_same(c.a);
        if (is_moved(c.b)) expect_same(c.b);
    }
}
// [rest.move.expect]

// [rest.places]
void RestEngine::find_places(const Group& group)
{
    if (group.has_ways) return;

    // [rest.places.mean]
    // Places move by the mean of the velocities before and after
    const double dt = motion_.span;
    for (const int member : group.members) {
        const Mover& old = motion_.before[member];
        const Mover& now = motion_.now[member];
        const Vec2 mean(0.5 * (old.v_x + now.v_x), 0.5 * (old.v_y + now.v_y));
        motion_.shift[member] += dt * mean;
        motion_.turn[member] += dt * (0.5 * (old.spin + now.spin));
    }
    // [rest.places.mean]
}
// [rest.places]

// [rest.move]
/// A body had no motion when the step began either, and what is expected of it now was expected then.
bool RestEngine::stood_alike(int member) const
{
    const Saved& old = saved_[member];
    return old.state.velocity.isZero(0.0) && old.state.spin == 0.0 && old.pull == motion_.pull[member] &&
           old.turn_pull == motion_.turn_pull[member] && old.in_crowd == in_crowd_[member];
}

void RestEngine::move_group(const Group& group)
{
    note_legs(group);

    // Remember what the points bore
    bool same = true;
    for (const ContactPoint& c : group.points) {
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
    for (const int member : group.members) {
        in_crowd_[member] = strikes_at_start(group) ? 1 : 0;
        BodyState& state = bodies_.list[member].state;
        const Mover& now = motion_.now[member];
        const Vec2& way = motion_.shift[member];
        same = same && way.x() == 0.0 && way.y() == 0.0 && motion_.turn[member] == 0.0 && now.v_x == 0.0 && now.v_y == 0.0 &&
               now.spin == 0.0 && stood_alike(member);
        state.position += way;
        state.angle += motion_.turn[member];
        state.velocity = Vec2(now.v_x, now.v_y);
        state.spin = now.spin;
        state.time = time() + options_.step;
    }

    // What a whole step leaves as it was, the next leaves too
    same = same && motion_.span == options_.step;
    for (const int member : group.members) {
        still_[member] = same ? 1 : 0;
        if (same && options_.sleeps) {
            asleep_[member] = 1;
            sleep_group_[member] = group.members.front();
        }
    }
}
// [rest.move]

} // namespace flying
