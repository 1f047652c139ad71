#include <algorithm>
#include <utility>

#include "rest/rest_engine.hpp"
#include "rest/step_field.hpp"

namespace flying {
namespace {

void expect_same(RestData& data, int body)
{
    const Mover& old = data.motion.before[body];
    const Mover& now = data.motion.now[body];
    data.motion.pull[body] = Vec2(now.v_x - old.v_x, now.v_y - old.v_y) / data.motion.span;
    data.motion.expected_angular_acceleration[body] = (now.spin - old.spin) / data.motion.span;
}

/// Bodies that bear a load will do what they did in this step; the others fly.
///
/// marks  of each body, all 0 before and after
void expect(RestData& data, const Island& island, std::span<char> marks)
{
    for (const ContactPoint& c : island.points) {
        if (c.normal != 0.0) marks[c.a] = marks[c.b] = 1;
    }
    for (const int member : island.members) {
        if (marks[member]) expect_same(data, member);
        else expect_flight(data, member, data.bodies.list[member].state.position + data.motion.shift[member]);
    }
    for (const ContactPoint& c : island.points) marks[c.a] = marks[c.b] = 0;
}

} // namespace

/// A body had no motion when the step began either, and what is expected of it now was expected then.
bool RestEngine::stood_alike(int member) const
{
    const BodyBefore& old = before_[member];
    return old.state.velocity.isZero(0.0) && old.state.spin == 0.0 && old.pull == data_.motion.pull[member] &&
           old.expected_angular_acceleration == data_.motion.expected_angular_acceleration[member] &&
           old.in_large_island == data_.bodies.in_large_island[member];
}

void RestEngine::move_island(const Island& island)
{
    // Remember what the points bore, as if a whole step had been like this part of it
    bool same = true;
    const double parts = data_.whole_step / data_.motion.span;
    for (const ContactPoint& c : island.points) {
        RestPair& pair = data_.pairs.pairs()[c.pair];
        const double normal = parts * c.normal;
        const double tangent = parts * c.tangent;
        same = same && pair.normal[c.own] == normal && pair.tangent[c.own] == tangent;
        pair.normal[c.own] = normal;
        pair.tangent[c.own] = tangent;
    }

    expect(data_, island, marks_);

    // Move
    for (const int member : island.members) {
        data_.bodies.in_large_island[member] = is_heap(island) ? 1 : 0;
        BodyState& state = data_.bodies.list[member].state;
        const Mover& now = data_.motion.now[member];
        const BodyState old = state;
        if (farthest_way(data_, member) > data_.motion.reach[member]) {
            BodyBefore& before = before_[member];
            before.reach = 0.0;
            before.thrown_at =
                std::min(before.thrown_at, data_.options.step - data_.motion.after - 0.5 * data_.motion.span);
        }
        state.position += data_.motion.shift[member];
        state.angle += data_.motion.turn[member];
        same = same && state.position == old.position && state.angle == old.angle && now.v_x == 0.0 && now.v_y == 0.0 &&
               now.spin == 0.0 && stood_alike(member);
        state.velocity = Vec2(now.v_x, now.v_y);
        state.spin = now.spin;
        state.time = time() + data_.options.step;
    }

    // What a whole step leaves as it was, the next leaves too
    if (!same || data_.motion.span != data_.options.step || !may_fall_asleep_) return;
    for (const int member : island.members) {
        if (sleepers_.is_asleep(member)) continue;
        sleepers_.put_to_sleep(member, island.members.front());
        data_.motion.reach[member] = farthest_[member] = reach_of(data_, member, 0.0);
    }
}

} // namespace flying
