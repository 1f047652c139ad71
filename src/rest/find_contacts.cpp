#include "rest/find_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "rest/corner_pass.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// The point of the last look that a point continues: the nearest at the same place, whatever the names of the
/// features, which change with rounding where corners lie on corners; or else that of the same features. -1 where there
/// is none.
[[nodiscard]] int known_point(const PairLoads& pair, std::uint32_t feature, const Vec2& place, double near)
{
    int best = -1;
    bool best_near = false;
    for (int i = 0; i < pair.count; ++i) {
        const bool is_near = (pair.place[i] - place).squaredNorm() < near * near;
        if (pair.feature[i] == feature && is_near) return i;
        if ((pair.feature[i] == feature && !best_near) || is_near) {
            best = i;
            best_near = is_near;
        }
    }
    return best;
}

/// A point that bore a load when the step before ended.
[[nodiscard]] bool bore(const RestPair& pair, std::uint32_t feature)
{
    for (int k = 0; k < pair.count; ++k) {
        if (pair.feature[k] == feature) return pair.normal[k] > 0.0;
    }
    return false;
}

/// The points of a pair that were open when the step began, and below which gap they count as closed.
struct Closing
{
    std::uint32_t open[2];
    int count;
    bool any_closed; ///< as it began; where none was, all were open, by whatever names they close
    double closed;   // [m]
    double speed;    ///< with which the first one closes [m/s]
};

/// Where a body's centre will be at a moment of the step, if it goes on as it did.
Vec2 place_at(const RestData& data, int body, double moment)
{
    const BodyState& s = data.bodies.list[body].state;
    return s.position + moment * (s.velocity + (0.5 * moment) * data.motion.pull[body]);
}

/// Where a body will be at a moment of the step, if it goes on as it did.
Pose pose_at(const RestData& data, int body, double moment)
{
    if (data.bodies.list[body].is_static) return data.bodies.poses[body];
    const BodyState& s = data.bodies.list[body].state;
    return {
        place_at(data, body, moment),
        Rotation::of(s.angle + moment * (s.spin + (0.5 * moment) * data.motion.expected_angular_acceleration[body]))};
}

/// Where the step ends there is a gap still, though it would close by how fast it opens and that changes now: round
/// ones that go round each other turn out of each other's way.
bool stays_open(const RestData& data, const RestPair& pair, double touch)
{
    return look(data, pair, pose_at(data, pair.a, data.motion.span), pose_at(data, pair.b, data.motion.span), touch)
               .count == 0;
}

/// Normal acceleration of B relative to A at a contact, if they go on as they did.
double fall_at(const RestData& data, const RestPair& pair, const Contact& contact, double moment)
{
    const auto pull = [&](int index) {
        const Vec2 r = contact.point - place_at(data, index, moment);
        return Vec2(data.motion.pull[index] + cross(data.motion.expected_angular_acceleration[index], r));
    };
    return (pull(pair.b) - pull(pair.a)).dot(contact.normal);
}

/// Time from a moment until the first gap closes; 0 where one that was open has closed by then, infinite where none
/// does.
double next_closing(const RestData& data, const RestPair& pair, const Manifold& manifold, double moment,
                    Closing& closing)
{
    const double left = data.motion.span - moment;
    // In a large island, what bore a load goes on to bear, whatever gap turning or a push out of an overlap has left
    const bool in_large_island = data.bodies.in_large_island[pair.a] || data.bodies.in_large_island[pair.b];
    double wait = std::numeric_limits<double>::infinity();
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        // Where corners meet, what was the corner nearest to a corner becomes one that lies on an edge
        std::uint32_t* const end = closing.open + closing.count;
        const bool was_open = !closing.any_closed || std::find(closing.open, end, contact.feature) != end;
        if (contact.separation <= closing.closed && !was_open) continue;
        const double field =
            data.motion.span * std::max(data.motion.field_size[pair.a], data.motion.field_size[pair.b]);
        const auto velocity = [&](int index) {
            const BodyState& s = data.bodies.list[index].state;
            const Vec2 r = contact.point - place_at(data, index, moment);
            return Vec2(s.velocity + moment * data.motion.pull[index] +
                        cross(s.spin + moment * data.motion.expected_angular_acceleration[index], r));
        };
        const double u = (velocity(pair.b) - velocity(pair.a)).dot(contact.normal);
        if (contact.separation <= closing.closed) {
            closing.speed = std::max(closing.speed, -u);
            return 0.0;
        }
        if (in_large_island && -u <= field && bore(pair, contact.feature)) continue;
        if (moment == 0.0) closing.open[closing.count++] = contact.feature;
        const double fall = fall_at(data, pair, contact, moment);
        const double time = time_to_close(contact.separation, u, fall, left);
        if (time > left || (u > 0.0 && stays_open(data, pair, closing.closed))) continue;
        wait = std::min(wait, time);
    }
    return wait;
}

/// How near to each other two bodies are looked at that get no further than so.  [m]
[[nodiscard]] double margin_of(const RestData& data, const RestPair& pair, std::span<const double> farthest)
{
    const double size = data.bodies.size_of(pair.a, pair.b);
    return farthest[pair.a] + farthest[pair.b] + rest_tolerance::k_watch * size;
}

[[nodiscard]] bool stands(const RestData& data, int body)
{
    const BodyState& s = data.bodies.list[body].state;
    return s.velocity.isZero(0.0) && s.spin == 0.0;
}

/// Where a body is when a step or a part of one begins: what the last such look has found may answer.
Manifold find_from_memory(RestData& data, RestPair& pair, double margin)
{
    NearMemory& memory = pair.memory;
    if (memory.knows_separation) {
        const double change =
            change_since_look(data.bodies, pair, data.bodies.poses[pair.a], data.bodies.poses[pair.b]);
        if (memory.separation - change > margin) return {};
        memory.edges.lead -= 2.0 * change;
        memory.knows_edges = memory.edges.lead > 0.0;
    }
    pair.shift = data.bodies.travel[pair.a].shift + data.bodies.travel[pair.b].shift;
    pair.turn = data.bodies.travel[pair.a].turn + data.bodies.travel[pair.b].turn;
    ++data.counts.manifolds;
    return data.looks.find_cached(data.bodies, data.pairs, pair, margin);
}

/// Corners that slide past each other bear along the side that they slide on.
void slide_past(const RestData& data, const RestPair& pair, Manifold& manifold)
{
    const std::optional<Vec2> side =
        side_at_passing(data, pair, manifold, data.bodies.poses[pair.a], data.bodies.poses[pair.b]);
    if (!side) return;
    manifold.count = 1;
    manifold.contacts[0].normal = *side;
    manifold.contacts[0].separation = 0.0;
}

/// What comes at a corner, and will slide past it, is no obstacle: seen along the side that it will slide on.
///
/// ahead    the pair at the moment at which the gap closes
/// closing  [out] with the speed at which it comes there
void see_past(const RestData& data, const RestPair& pair, const Manifold& ahead, double moment, Manifold& manifold,
              Closing& closing)
{
    const double approach =
        -opening_speed(manifold.contacts[0], data.bodies.list[pair.a].state, data.bodies.list[pair.b].state);
    if (!comes_near(data, pair, approach)) return;
    std::optional<Vec2> side;
    if (!comes_near(data, pair, closing.speed)) side = ahead.contacts[0].normal;
    else side = side_at_passing(data, pair, ahead, pose_at(data, pair.a, moment), pose_at(data, pair.b, moment));
    if (!side) return;
    for (Contact& contact : manifold.contacts) contact.normal = *side;
    closing.speed = std::max(closing.speed, approach);
}

/// The points of a pair bear what those bore that they continue.
void recall_loads(const RestData& data, RestPair& pair, const Manifold& manifold)
{
    const int own = data.motion.is_moved(pair.a) ? pair.a : pair.b;
    const double size = data.bodies.size_of(pair.a, pair.b);
    const Rotation own_from_world = inverse(data.bodies.poses[own].rotation);
    PairLoads now;
    now.count = manifold.count;
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        const Vec2 place = own_from_world * Vec2(contact.point - data.bodies.poses[own].position);
        const int known = known_point(pair, contact.feature, place, rest_tolerance::k_watch * size);
        now.feature[k] = contact.feature;
        now.place[k] = place;
        now.normal[k] = known >= 0 ? pair.normal[known] : 0.0;
        now.tangent[k] = known >= 0 ? pair.tangent[known] : 0.0;
    }
    static_cast<PairLoads&>(pair) = now;
}

/// The points at which the pair touches, or might, as a step or a part of one begins. Two that stand, and have not
/// moved by a bit since the last such look, touch as they did.
///
/// room  for what is found, where it isn't remembered
const Manifold& look_at_start(RestData& data, RestPair& pair, double margin, Manifold& room)
{
    LastLook& last = pair.last_look;
    const bool stand = stands(data, pair.a) && stands(data, pair.b);
    const std::int64_t moves = data.bodies.moves[pair.a] + data.bodies.moves[pair.b];
    if (stand && last.moves == moves && last.margin == margin) return last.manifold;
    last.moves = stand ? moves : -1;
    last.margin = margin;
    Manifold& found = stand ? last.manifold : room;
    found.count = 0;
    if (may_touch(data, pair, data.motion.reach)) found = find_from_memory(data, pair, margin);
    if (!stand) slide_past(data, pair, found);
    if (found.count > 0) recall_loads(data, pair, found);
    else pair.count = 0;
    return found;
}

void add_points(const RestData& data, int index, const Manifold& manifold, double closes_at, double closing_speed,
                std::vector<ContactPoint>& found)
{
    const RestPair& pair = data.pairs.pairs()[index];
    const double part = data.motion.span / data.whole_step;
    for (int k = 0; k < pair.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        found.push_back({.a = pair.a,
                         .b = pair.b,
                         .pair = index,
                         .own = k,
                         .friction = pair.friction,
                         .restitution = pair.restitution,
                         .gap = contact.separation,
                         .normal = part * pair.normal[k],
                         .tangent = part * pair.tangent[k],
                         .closes_at = closes_at,
                         .closing_speed = closing_speed});
        const Vec2 r_a = contact.point - data.bodies.poses[pair.a].position;
        const Vec2 r_b = contact.point - data.bodies.poses[pair.b].position;
        data.motion.set_arms(found.back(), contact.normal, r_a, r_b);
    }
}

} // namespace

double opening_speed(const Contact& contact, const BodyState& a, const BodyState& b)
{
    const Vec2 of_a = velocity_at(a, contact.point - a.position);
    const Vec2 of_b = velocity_at(b, contact.point - b.position);
    return (of_b - of_a).dot(contact.normal);
}

double time_to_close(double gap, double u, double a, double within)
{
    if (gap + within * (u + 0.5 * a * within) > 0.0) return 2.0 * within;
    const double square = u * u - 2.0 * a * gap;
    const double root = std::sqrt(std::max(square, 0.0));
    return 2.0 * gap / (root - u);
}

bool may_touch(const RestData& data, const RestPair& pair, std::span<const double> farthest)
{
    return are_near(data, pair, data.bodies.poses[pair.a], data.bodies.poses[pair.b], margin_of(data, pair, farthest));
}

void find_contacts(RestData& data, int index, std::vector<ContactPoint>& found)
{
    RestPair& pair = data.pairs.pairs()[index];

    // Leave out those too far from each other for this step
    const double size = data.bodies.size_of(pair.a, pair.b);
    const double margin = margin_of(data, pair, data.motion.reach);
    Manifold room;
    const Manifold& manifold = look_at_start(data, pair, margin, room);
    if (manifold.count == 0) return;

    // A gap that would close within the step is looked at when it does; bodies turn, so that one look may not do
    const Pose& pose_a = data.bodies.poses[pair.a];
    const Pose& pose_b = data.bodies.poses[pair.b];
    Closing closing{{0, 0}, 0, false, data.bodies.touch_gap(pair.a, pose_a.position, pair.b, pose_b.position), 0.0};
    Manifold ahead = manifold;
    double moment = 0.0;
    double closes_at = std::numeric_limits<double>::infinity();
    bool overlaps = false;
    const double fair = rest_tolerance::k_fair_overlap * data.bodies.breadth_of(pair.a, pair.b);
    for (int k = 0; k < manifold.count; ++k) {
        closing.any_closed = closing.any_closed || manifold.contacts[k].separation <= closing.closed;
        overlaps = overlaps || manifold.contacts[k].separation < -fair;
    }
    for (int k = 0; k <= rest_tolerance::k_quick_rounds && !overlaps; ++k) {
        const double wait = next_closing(data, pair, ahead, moment, closing);
        if (wait == 0.0) closes_at = moment;
        if (wait == 0.0 || !(moment + wait <= (1.0 - rest_tolerance::k_at_once) * data.motion.span)) break;
        moment += wait;
        ++data.counts.manifolds;
        ahead = look(data, pair, pose_at(data, pair.a, moment), pose_at(data, pair.b, moment), margin);
        closing.closed = rest_tolerance::k_closed * size;
    }
    if (std::isinf(closes_at)) {
        add_points(data, index, manifold, closes_at, closing.speed, found);
        return;
    }
    Manifold seen = manifold;
    see_past(data, pair, ahead, closes_at, seen, closing);
    add_points(data, index, seen, closes_at, closing.speed, found);
}

} // namespace flying
