#include "rest/rest_engine.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "math/hash.hpp"
#include "rest/body_order.hpp"
#include "rest/find_contacts.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/step_field.hpp"

namespace flying {
RestEngine::RestEngine(std::vector<RestBody> bodies, const RestOptions& options, double time)
    : RestEngine(bodies, options, time, order_in_memory(bodies, options.most_solved))
{
}

RestEngine::RestEngine(std::vector<RestBody> bodies, const RestOptions& options, double time, std::vector<int> order)
    : data_(options, RestBodies(std::move(bodies), std::move(order), time)),
      start_(time),
      farthest_(data_.bodies.list.size(), 0.0),
      sleepers_(data_.bodies.count()),
      stepped_(data_.bodies.count()),
      before_(data_.bodies.list.size()),
      marks_(data_.bodies.list.size(), 0)
{
    parts_.of.assign(data_.bodies.list.size(), -1);
    for (int k = 0; k < data_.bodies.count(); ++k) {
        expect_flight(data_, k, data_.bodies.list[k].state.position);
        stirred_.push_back(k);
    }
}

void RestEngine::advance(double time)
{
    // A step whose end is `time` but for rounding still fits
    const double last = time + 0.5 * tolerance::coordinate_rounding(std::abs(time));
    while (start_ + static_cast<double>(steps_ + 1) * data_.options.step <= last) step();
}

void RestEngine::set_state(int number, const BodyState& state)
{
    const int body = data_.bodies.place[number];
    data_.bodies.list[body].state = state;
    data_.bodies.list[body].state.time = time();
    data_.bodies.set_pose(body, state);
    data_.motion.end_poses[body] = data_.bodies.poses[body];
    expect_flight(data_, body, state.position);
    data_.pairs.invalidate();
    wake_all_with(body);
}

void RestEngine::set_active(int number, bool active)
{
    const int body = data_.bodies.place[number];
    if (data_.bodies.list[body].is_active == active) return;
    wake_all_with(body);
    data_.bodies.list[body].is_active = active;
    stirred_.push_back(body);
    data_.pairs.invalidate();
}

void RestEngine::wake_all_with(int body)
{
    sleepers_.wake(sleepers_.island_of(body));
    data_.pairs.for_each_of(body, [&](std::span<const RestPair> pairs) {
        if (std::none_of(pairs.begin(), pairs.end(), [](const RestPair& pair) { return pair.count > 0; })) return;
        sleepers_.wake(sleepers_.island_of(pairs.front().a));
        sleepers_.wake(sleepers_.island_of(pairs.front().b));
    });
}

std::vector<RestContact> RestEngine::contacts() const
{
    std::vector<RestContact> result;
    for (const RestPair& pair : data_.pairs.all()) {
        if (pair.count == 0) continue;
        const double margin =
            data_.motion.reach[pair.a] + data_.motion.reach[pair.b] + 2.0 * data_.bodies.touch_gap(pair.a, pair.b);
        const Manifold manifold = look(data_, pair, pose_of(data_.bodies.list[pair.a].state),
                                       pose_of(data_.bodies.list[pair.b].state), margin);
        for (int k = 0; k < pair.count; ++k) {
            for (int i = 0; i < manifold.count; ++i) {
                if (manifold.contacts[i].feature != pair.feature[k]) continue;
                result.push_back({data_.bodies.order[pair.a], data_.bodies.order[pair.b], manifold.contacts[i].normal,
                                  manifold.contacts[i].separation, pair.normal[k] / data_.options.step,
                                  pair.tangent[k] / data_.options.step});
                RestContact& contact = result.back();
                if (contact.a < contact.b) continue;
                std::swap(contact.a, contact.b);
                contact.normal = -contact.normal;
            }
        }
    }
    std::stable_sort(result.begin(), result.end(), [](const RestContact& one, const RestContact& two) {
        return std::tie(one.a, one.b) < std::tie(two.a, two.b);
    });
    return result;
}

std::vector<int> RestEngine::islands() const
{
    std::vector<int> island(data_.bodies.list.size());
    for (std::size_t k = 0; k < island.size(); ++k) island[k] = static_cast<int>(k);
    const auto root = [&](int k) {
        while (island[k] != k) k = island[k] = island[island[k]];
        return k;
    };
    for (const RestContact& contact : contacts()) {
        if (body(contact.a).is_static || body(contact.b).is_static) continue;
        if (contact.normal_force == 0.0 &&
            contact.gap > data_.bodies.touch_gap(data_.bodies.place[contact.a], data_.bodies.place[contact.b]))
            continue;
        const int one = root(contact.a);
        const int two = root(contact.b);
        island[std::max(one, two)] = std::min(one, two);
    }
    for (int k = 0; k < static_cast<int>(island.size()); ++k) {
        island[k] = body(k).is_static || !body(k).is_active ? -1 : root(k);
    }
    return island;
}

std::uint64_t RestEngine::hash() const
{
    Hash hash;
    for (const int place : data_.bodies.place) {
        const BodyState& s = data_.bodies.list[place].state;
        for (const double x : {s.position.x(), s.position.y(), s.angle, s.velocity.x(), s.velocity.y(), s.spin})
            hash.add(x);
    }
    return hash.value();
}

void RestEngine::step_by(double length, double end)
{
    const double whole = data_.options.step;
    if (length == whole) {
        step();
    } else {
        // What a step leaves as it was, a halved one does too, and shows that it does: it is made of half of the same
        // numbers, or a quarter. One of another length rounds
        const bool sleeps = data_.options.sleeps;
        int halvings = 0;
        may_fall_asleep_ = std::frexp(length / whole, &halvings) == 0.5;
        leave_out_sleepers(sleeps || !may_fall_asleep_);
        data_.options.step = length;
        step();
        data_.options.step = whole;
        leave_out_sleepers(sleeps);
        may_fall_asleep_ = true;
    }
    set_time(end);
}

void RestEngine::leave_out_sleepers(bool are_left_out)
{
    if (std::exchange(data_.options.sleeps, are_left_out) == are_left_out) return;
    for (int k = 0; k < data_.bodies.count(); ++k) {
        if (sleepers_.is_asleep(k)) stirred_.push_back(k);
    }
}

void RestEngine::set_time(double time)
{
    start_ = time;
    steps_ = 0;
}

std::vector<int> RestEngine::find_clear(double within)
{
    list_stepped();
    // The list was made for the last step, and that may have been a short one
    for (const int k : stepped_.list()) {
        farthest_[k] = reach_of(data_, k, within);
        data_.bodies.set_pose(k, data_.bodies.list[k].state);
    }
    (void)list_pairs();
    for (const int k : stepped_.list()) marks_[k] = sleepers_.is_asleep(k) ? 0 : 1;
    for (const RestPair& pair : data_.pairs.pairs()) {
        if (!marks_[pair.a] && !marks_[pair.b]) continue;
        double load = 0.0;
        for (int k = 0; k < pair.count; ++k) load += pair.normal[k];
        if ((load > 0.0 || !stays_apart(pair, within)) && !bounces(pair, load)) marks_[pair.a] = marks_[pair.b] = 0;
    }
    std::vector<int> clear;
    for (const int k : stepped_.list()) {
        if (marks_[k]) clear.push_back(data_.bodies.order[k]);
        marks_[k] = 0;
    }
    std::sort(clear.begin(), clear.end());
    return clear;
}

/// The pair doesn't lean, but bounces, and nothing is lost by that: impacts bring about what the last step took for a
/// load.
///
/// load  impulse of that step [N s]
bool RestEngine::bounces(const RestPair& pair, double load) const
{
    if (pair.restitution != 1.0 || pair.friction != 0.0) return false;
    const double step = data_.options.step;
    const double push =
        load * (data_.bodies.list[pair.a].inertia.inv_mass + data_.bodies.list[pair.b].inertia.inv_mass);

    // Hops that are too low can't be told from contact
    const auto pull = [&](int index) {
        return data_.bodies.list[index].is_static ? Vec2(Vec2::Zero())
                                                  : field_at(data_, index, data_.bodies.list[index].state.position);
    };
    const RestBody& a = data_.bodies.list[pair.a];
    const RestBody& b = data_.bodies.list[pair.b];
    const Pose& pose_a = data_.bodies.poses[pair.a];
    const Pose& pose_b = data_.bodies.poses[pair.b];
    const Vec2 fall = pull(pair.b) - pull(pair.a);
    const double press = std::max(step * fall.norm(), push);
    const double least = rest_tolerance::k_blow * press;
    const double near = data_.bodies.size_of(pair.a, pair.b);
    const Manifold manifold = look(data_, pair, pose_a, pose_b, rest_tolerance::k_closed * near);
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        if (contact.separation < -data_.bodies.touch_gap(pair.a, pair.b)) return false; // steps take that off first
        const double u = opening_speed(contact, a.state, b.state);
        const double f = std::min(0.0, fall.dot(contact.normal));
        if (u * u - 2.0 * f * std::max(contact.separation, 0.0) < least * least) return false;
    }
    return true;
}

/// No point of the pair closes for so long.
bool RestEngine::stays_apart(const RestPair& pair, double within) const
{
    const RestBody& a = data_.bodies.list[pair.a];
    const RestBody& b = data_.bodies.list[pair.b];
    const auto turning = [&](int index) {
        const RestBody& body = data_.bodies.list[index];
        return body.is_static ? 0.0 : std::abs(body.state.spin) * data_.bodies.radius[index];
    };
    const auto pull = [&](int index) {
        const bool rests = data_.bodies.list[index].is_static || sleepers_.is_asleep(index);
        return rests ? Vec2(Vec2::Zero()) : field_at(data_, index, data_.bodies.list[index].state.position);
    };
    const double turns = turning(pair.a) + turning(pair.b);
    const double top = a.state.velocity.norm() + b.state.velocity.norm() + turns;
    const double closing = (b.state.velocity - a.state.velocity).norm() + turns; // at most
    const Vec2 fall = pull(pair.b) - pull(pair.a);
    const double touch = data_.bodies.touch_gap(pair.a, pair.b);
    const double margin = within * (closing + 0.5 * within * fall.norm()) + touch;

    // Look at the points that are near
    const Pose& pose_a = data_.bodies.poses[pair.a];
    const Pose& pose_b = data_.bodies.poses[pair.b];
    if (!are_near(data_, pair, pose_a, pose_b, margin)) return true;
    const Manifold manifold = look(data_, pair, pose_a, pose_b, margin);
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        double u = opening_speed(contact, a.state, b.state);
        if (std::abs(u) <= rest_tolerance::k_rounding * top) u = 0.0;
        const double f = fall.dot(contact.normal);
        if (contact.separation < -touch) return false;
        if (u >= 0.0 && f >= 0.0) continue;

        // The gap is least at the end, or where the approach ends before
        const double least_at = u < 0.0 && f > 0.0 ? std::min(within, -u / f) : within;
        if (!(contact.separation + least_at * (u + 0.5 * least_at * f) > touch)) return false;
    }
    return true;
}

RestEngine::Memory RestEngine::memory() const
{
    Memory memory{time(), data_.bodies.order, {}, data_.pairs.all(), data_.max_overlap};
    for (std::size_t k = 0; k < data_.bodies.list.size(); ++k) {
        memory.bodies.push_back({data_.bodies.list[k].state, data_.motion.pull[k],
                                 data_.motion.expected_angular_acceleration[k], data_.motion.reach[k],
                                 sleepers_.island_of(static_cast<int>(k)), data_.bodies.list[k].is_active,
                                 data_.bodies.in_large_island[k] != 0});
    }
    return memory;
}

void RestEngine::go_on_from(const Memory& memory)
{
    if (memory.order != data_.bodies.order) {
        std::vector<RestBody> bodies;
        for (const int place : data_.bodies.place) bodies.push_back(data_.bodies.list[place]);
        *this = RestEngine(std::move(bodies), data_.options, memory.time, memory.order);
    }
    set_time(memory.time);
    data_.max_overlap = memory.max_overlap;
    for (std::size_t k = 0; k < data_.bodies.list.size(); ++k) {
        const Memory::Body& body = memory.bodies[k];
        data_.bodies.list[k].state = body.state;
        data_.bodies.list[k].is_active = body.is_active;
        data_.motion.pull[k] = body.pull;
        data_.motion.expected_angular_acceleration[k] = body.expected_angular_acceleration;
        data_.motion.reach[k] = body.reach;
        stirred_.push_back(static_cast<int>(k));
        data_.bodies.in_large_island[k] = body.in_large_island ? 1 : 0;
        data_.bodies.set_pose(static_cast<int>(k), body.state);
        data_.motion.end_poses[k] = data_.bodies.poses[k];
        if (data_.bodies.list[k].is_static) continue;
        Mover& mover = data_.motion.now[k];
        mover.v_x = body.state.velocity.x();
        mover.v_y = body.state.velocity.y();
        mover.spin = body.state.spin;
        data_.motion.before[k] = mover;
    }
    for (std::size_t k = 0; k < data_.bodies.list.size(); ++k) {
        const int body = static_cast<int>(k);
        if (sleepers_.island_of(body) != memory.bodies[k].sleep_island) sleepers_.wake(sleepers_.island_of(body));
    }
    for (std::size_t k = 0; k < data_.bodies.list.size(); ++k) {
        const int body = static_cast<int>(k);
        const int island = memory.bodies[k].sleep_island;
        if (island >= 0 && !sleepers_.is_asleep(body)) sleepers_.put_to_sleep(body, island);
    }
    list_stepped();
    std::vector<RestPair> pairs = memory.pairs;
    for (RestPair& pair : pairs) { // ways, and moves, are counted from another beginning
        pair.memory = {};
        pair.last_look = {};
    }
    data_.pairs.remember(std::move(pairs), data_.bodies, stepped_);
}

std::vector<std::optional<BodyState>> RestEngine::foresee(double length, double end, double since)
{
    const Memory before = memory();
    const RestCounts counts = data_.counts;
    const SolveCounts solves = data_.solver.counts();
    WithinStep within{since, {}};
    within.states.resize(data_.bodies.list.size());
    within_ = &within;
    step_by(length, end);
    within_ = nullptr;
    go_on_from(before);
    data_.counts = counts;
    data_.solver.counts() = solves;
    std::vector<std::optional<BodyState>> states;
    for (const int place : data_.bodies.place) states.push_back(within.states[place]);
    return states;
}

} // namespace flying
