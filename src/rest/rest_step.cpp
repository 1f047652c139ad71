// One step of the resting engine, and its parts where it has to end early.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "rest/energy_limit.hpp"
#include "rest/find_contacts.hpp"
#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/step_field.hpp"
#include "rest/stopwatch.hpp"

namespace flying {
namespace {

constexpr double k_never = std::numeric_limits<double>::infinity();

} // namespace

void RestEngine::step()
{
    Stopwatch watch(data_.options.seconds);
    data_.motion.span = data_.options.step;
    data_.motion.after = 0.0;
    begin_stepped();
    if (moved_.empty()) {
        ++steps_;
        ++data_.counts.steps;
        return;
    }
    (void)list_pairs();
    watch.stop(seconds_.pairs);

    // [rest.step.find]
    do {
        found_.clear();
        const int count = static_cast<int>(data_.pairs.pairs().size());
        data_.counts.pairs += count;
        for (int k = 0; k < count; ++k) find_contacts(data_, k, found_);
    } while (wake_touched() || list_what_impacts_reach());
    watch.stop(seconds_.collide);
    // [rest.step.find]

    for (const Island& island : islands_.all()) {
        for (const int member : island.members) before_[member].island = island.members.front();
        for (const ContactPoint& point : island.points) data_.max_overlap = std::max(data_.max_overlap, -point.gap);
    }
    parts_.made = parts_.looks = 0;
    parts_.are_again = false;
    solve_islands();
    watch.stop(seconds_.solve);
    make_parts(finish_islands(0, {}));
    Meetings met;
    for (int round = 0; round < rest_tolerance::k_quick_rounds; ++round) {
        std::vector<CutIsland> again = go_back(met);
        if (again.empty()) break;
        make_parts(std::move(again));
    }
    watch.stop(seconds_.move);
    ++steps_;
    ++data_.counts.steps;
}

/// Puts right the list of those that steps are for, and the pairs of theirs, where any fell asleep, woke, came or went.
void RestEngine::list_stepped()
{
    std::vector<int> changed = sleepers_.fetch_changed();
    bool any_pairs = !stirred_.empty();
    changed.insert(changed.end(), stirred_.begin(), stirred_.end());
    stirred_.clear();
    if (changed.empty()) return;
    std::vector<int> woken;
    std::vector<int> gone;
    for (const int k : changed) {
        const RestBody& body = data_.bodies.list[k];
        const bool is_left_out = data_.options.sleeps && sleepers_.is_asleep(k);
        const bool is_stepped = body.is_active && !body.is_static && !is_left_out;
        if (is_stepped != stepped_.has(k)) (is_stepped ? woken : gone).push_back(k);
    }
    stepped_.insert(woken);
    stepped_.erase(gone);
    any_pairs = any_pairs || !woken.empty() || !gone.empty();
    if (any_pairs) data_.pairs.separate(data_.bodies, stepped_);
}

/// A step begins for those that it is for.
void RestEngine::begin_stepped()
{
    list_stepped();
    data_.counts.asleep += data_.options.sleeps ? sleepers_.count() : 0;
    moved_.assign(stepped_.list().begin(), stepped_.list().end());
    begin(moved_);
}

/// Remembers bodies as they are before the step, each as an island of its own, and how far each may get.
void RestEngine::begin(std::span<const int> bodies)
{
    measure_reach(bodies);
    for (const int k : bodies) {
        before_[k] = {data_.bodies.list[k].state,
                      data_.motion.pull[k],
                      data_.motion.expected_angular_acceleration[k],
                      data_.motion.reach[k],
                      data_.motion.reach[k],
                      k_never,
                      k,
                      data_.bodies.in_large_island[k]};
        farthest_[k] = data_.motion.reach[k];
    }
}

/// Islands that something awake touches, or may come to touch within the step, wake. What is only near, as a disc that
/// rolls slowly beside a heap, leaves them asleep: they are no island with it, whether sleepers are left out or not.
bool RestEngine::wake_touched()
{
    if (sleepers_.count() == 0) return false;
    const auto is_between = [&](const ContactPoint& point) {
        return data_.motion.is_moved(point.a) && data_.motion.is_moved(point.b) &&
               sleepers_.island_of(point.a) != sleepers_.island_of(point.b);
    };
    const auto touches = [&](const ContactPoint& point) {
        const bool a_sleeps = sleepers_.is_asleep(point.a);
        if (a_sleeps && sleepers_.is_asleep(point.b)) return false;
        const int awake = a_sleeps ? point.b : point.a;
        return goes_far(data_, awake) || holds(data_, point, data_.motion.field_size[awake]);
    };
    std::vector<int> touched;
    for (const ContactPoint& point : found_) {
        if (is_between(point) && touches(point)) touched.push_back(sleepers_.is_asleep(point.a) ? point.a : point.b);
    }
    for (const int body : touched) sleepers_.wake(sleepers_.island_of(body));
    if (touched.empty()) std::erase_if(found_, is_between);
    else begin_stepped();
    return !touched.empty();
}

/// Begins a step, or a part of one, for some bodies: how far each may get in it, and what is expected to act.
void RestEngine::measure_reach(std::span<const int> bodies)
{
    StepMotion& motion = data_.motion;
    const double dt = motion.span;
    for (const int k : bodies) {
        const RestBody& body = data_.bodies.list[k];
        const double radius = data_.bodies.radius[k];
        const double speed = body.state.velocity.norm() + std::abs(body.state.spin) * radius;
        motion.reach[k] = reach_of(data_, k, sleepers_.is_asleep(k) ? 0.0 : dt);
        // What would carry a body beyond its reach in a part of a step was no load: it was taken from a shorter one
        const double more =
            0.5 * (dt * dt) * (motion.pull[k].norm() + std::abs(motion.expected_angular_acceleration[k]) * radius);
        const double room = motion.reach[k] - dt * speed;
        if (dt < data_.options.step && more > room) {
            motion.pull[k] *= room / more;
            motion.expected_angular_acceleration[k] *= room / more;
        }
        aim_field(data_, k);
        motion.now[k] = mover_of(body);
        motion.before[k] = motion.now[k];
        data_.bodies.set_pose(k, body.state);
        motion.shift[k] = Vec2::Zero();
        motion.turn[k] = 0.0;
    }
}

/// Sees to it that the list of pairs holds whatever bodies may touch that get no further than they may. True where it
/// is another now.
bool RestEngine::list_pairs()
{
    const PairReach reach{farthest_, data_.motion.reach};
    const int boxes = data_.pairs.update(data_.bodies, reach, stepped_);
    data_.counts.looks += boxes > 0 ? 1 : 0;
    data_.counts.boxes += boxes;
    return boxes > 0;
}

/// Splits the bodies into islands, and lists the pairs of those that an impact may throw: it gives none more than twice
/// the speed of the fastest. (Of a heap few are thrown, and those may go back.) True where the list is another now.
bool RestEngine::list_what_impacts_reach()
{
    islands_.split(data_, moved_, found_);
    bool any = false;
    for (const Island& island : islands_.all()) {
        const auto closes = [](const ContactPoint& c) { return std::isfinite(c.closes_at); };
        if (is_heap(island) || std::none_of(island.points.begin(), island.points.end(), closes)) continue;
        const double thrown = data_.motion.span * 2.0 * top_speed(data_, island);
        for (const int member : island.members) {
            any = any || thrown > farthest_[member];
            farthest_[member] = std::max(farthest_[member], thrown);
        }
    }
    return any && list_pairs();
}

void RestEngine::solve_islands()
{
    data_.counts.islands += static_cast<std::int64_t>(islands_.all().size());
    data_.counts.points += static_cast<std::int64_t>(islands_.point_count());
    for (Island& island : islands_.all()) island_step_.find(data_, island, may_be_parted(island));
}

/// Moves islands to the end of their step, or part of one, and says which of them end early.
std::vector<RestEngine::CutIsland> RestEngine::finish_islands(int depth, std::span<const int> pairs)
{
    std::vector<CutIsland> cut;
    const double whole = data_.motion.span;
    for (Island& island : islands_.all()) {
        if (island.cut_at == 0.0)
            island.cut_at = island_step_.end_early(data_, island, may_be_halved(island, depth), within_);
        if (island.cut_at > 0.0) {
            for (const int member : island.members) parts_.of[member] = static_cast<int>(cut.size());
            cut.push_back({.members = {island.members.begin(), island.members.end()},
                           .pairs = {},
                           .ends = {whole, island.cut_at},
                           .after = data_.motion.after,
                           .depth = depth});
            continue;
        }
        if (!island.points.empty()) {
            count_elastic_loss(data_, island);
            limit_energy(data_, island);
        }
        move_island(island);
    }
    if (!cut.empty()) find_pairs_of(cut, pairs);
    return cut;
}

/// There may be more parts of its step, at impacts that have moments of their own.
bool RestEngine::may_be_parted(const Island& island) const
{
    if (island.is_row) return parts_.made < rest_tolerance::k_most_parts * parts_.bodies;
    if (parts_.made >= rest_tolerance::k_most_parts) return false;
    if (!is_heap(island)) return parts_.looks < rest_tolerance::k_most_looks || is_lossless(island);
    return parts_.looks < rest_tolerance::k_few_sweeps * rest_tolerance::k_most_whole && is_loose(data_, island);
}

/// The same where nothing says where to part it; the step of a small island, however many impacts it had.
bool RestEngine::may_be_halved(const Island& island, int depth) const
{
    const int most = is_heap(island) ? rest_tolerance::k_quick_rounds : rest_tolerance::k_most_parts;
    return depth < rest_tolerance::k_most_parts && data_.motion.span * most > data_.options.step;
}

/// pairs  among which they are; empty for all
void RestEngine::find_pairs_of(std::span<CutIsland> islands, std::span<const int> pairs)
{
    // A pair belongs to the island that both its bodies belong to, or the one that moves. The list may hold more than
    // those that may meet, which depends on when it was made
    const bool is_first = pairs.empty();
    const auto island_of = [&](const RestPair& pair) {
        const int a = parts_.of[pair.a];
        const int b = parts_.of[pair.b];
        if (data_.bodies.list[pair.a].is_static) return b;
        if (data_.bodies.list[pair.b].is_static) return a;
        return a == b ? a : -1;
    };
    const auto is_listed = [&](const RestPair& pair) {
        return may_touch(data_, pair, farthest_) && may_meet(data_.bodies, pair.a, pair.b, farthest_);
    };
    const int count = static_cast<int>(is_first ? data_.pairs.pairs().size() : pairs.size());
    for (int k = 0; k < count; ++k) {
        const int index = is_first ? k : pairs[k];
        const RestPair& pair = data_.pairs.pairs()[index];
        const int island = island_of(pair);
        if (island >= 0 && is_listed(pair)) islands[island].pairs.push_back(index);
    }
    for (const CutIsland& island : islands) {
        for (const int member : island.members) parts_.of[member] = -1;
    }
}

/// The steps of islands that end early: the parts up to there, and what is left. A part may be cut again, and what was
/// cut last is made first.
void RestEngine::make_parts(std::vector<CutIsland> islands)
{
    std::vector<CutIsland> waiting;
    for (CutIsland& island : islands) {
        parts_.bodies = static_cast<int>(island.members.size());
        parts_.made = parts_.looks = 0;
        waiting.push_back(std::move(island));
        while (!waiting.empty()) {
            std::vector<CutIsland> cut = make_part(waiting.back());
            if (waiting.back().ends.empty()) {
                waiting.pop_back();
                ++data_.counts.parts;
            }
            for (; !cut.empty(); cut.pop_back()) waiting.push_back(std::move(cut.back()));
        }
    }
    data_.motion.span = data_.options.step;
    data_.motion.after = 0.0;
}

/// The next part of the step of an island: all is looked at again. What of it ends early.
std::vector<RestEngine::CutIsland> RestEngine::make_part(CutIsland& island)
{
    const double end = island.ends.back();
    const double length = end - std::exchange(island.begun, end);
    data_.motion.after = island.after + (island.ends.front() - end);
    island.ends.pop_back();
    if (!(length > 0.0)) return {};

    data_.motion.span = length;
    begin_part(island.members, island.depth);
    found_.clear();
    const auto both_move = [&](const RestPair& pair) {
        return !data_.bodies.list[pair.a].is_static && !data_.bodies.list[pair.b].is_static;
    };
    ++parts_.made;
    for (const int pair : island.pairs) {
        parts_.looks += both_move(data_.pairs.pairs()[pair]) ? 1 : 0;
        find_contacts(data_, pair, found_);
    }
    islands_.split(data_, island.members, found_);
    solve_islands();
    return finish_islands(island.depth + 1, island.pairs);
}

/// A part of the step begins. As parts of a whole step begin, all is looked at; what may get further in a part of a
/// part has been thrown. In a whole step that is made again bodies are thought to get as far as it threw them.
void RestEngine::begin_part(std::span<const int> bodies, int depth)
{
    measure_reach(bodies);
    const double share = data_.motion.span / data_.options.step;
    const double now = data_.options.step - data_.motion.after - data_.motion.span;
    for (const int k : bodies) {
        BodyBefore& old = before_[k];
        double& reach = data_.motion.reach[k];
        if (parts_.are_again) reach = std::max(reach, share * farthest_[k]);
        old.is_parted = true;
        if (depth == 0) old.looked_for = reach;
        else if (reach > old.looked_for) old.thrown_at = std::min(old.thrown_at, now);
    }
}

/// Islands that met, and were not thought to, go back, to make their step in parts that begin whenever any of them has
/// met: as a part begins, all is looked at again. A heap, if its masses don't differ much, makes it again whole, and
/// looks further. All of them as one; none where none has met.
///
/// met  of the step so far: those that went back before do it again, or they would be met where they no longer are
std::vector<RestEngine::CutIsland> RestEngine::go_back(Meetings& met)
{
    std::vector<BodyPose> thrown;
    for (const int k : moved_) {
        const double way = way_since(data_, before_[k], k);
        const bool is_thrown = way > before_[k].reach;
        if (!is_thrown && !before_[k].is_parted) continue;
        if (is_thrown) farthest_[k] = std::max(farthest_[k], 2.0 * way);
        thrown.push_back({k, pose_of(data_.bodies.list[k].state)});
    }
    if (thrown.empty()) return {};
    const std::vector<RestPair> pairs = data_.pairs.pairs_at(thrown, data_.bodies);
    if (!find_meetings(data_, pairs, before_, stepped_, met)) return {};
    wake_met(met);
    bool any_heap = false;
    std::vector<CutIsland> again(1);
    std::vector<int>& members = again.front().members;
    for (const int k : moved_) {
        if (!std::binary_search(met.islands.begin(), met.islands.end(), before_[k].island)) continue;
        BodyBefore& old = before_[k];
        old.thrown_at = k_never;
        any_heap = any_heap || data_.bodies.in_large_island[k] != 0;
        sleepers_.wake(sleepers_.island_of(k));
        data_.bodies.list[k].state = old.state;
        data_.bodies.set_pose(k, old.state);
        data_.bodies.in_large_island[k] = old.in_large_island;
        data_.motion.pull[k] = old.pull;
        data_.motion.expected_angular_acceleration[k] = old.expected_angular_acceleration;
        members.push_back(k);
        parts_.of[k] = 0;
    }
    parts_.are_again = any_heap && !are_unequal(data_, members);
    std::vector<double>& ends = again.front().ends;
    ends.assign(1, data_.motion.span);
    if (!parts_.are_again) ends.insert(ends.end(), met.moments.rbegin(), met.moments.rend());
    (void)list_pairs(); // from where they are again
    find_pairs_of(again, {});
    return again;
}

/// What slept and was met is awake, and goes back with the others: a step that had left it as it was is what it has
/// made so far.
void RestEngine::wake_met(Meetings& met)
{
    std::vector<int> woken;
    for (const int body : met.sleepers) {
        const int island = sleepers_.island_of(body);
        const std::vector<int> members = sleepers_.members(island);
        if (!sleepers_.wake(island)) continue;
        begin(members);
        for (const int k : members) before_[k].island = island;
        met.islands.push_back(island);
        woken.insert(woken.end(), members.begin(), members.end());
    }
    met.sleepers.clear();
    if (woken.empty()) return;
    std::sort(met.islands.begin(), met.islands.end());
    moved_.insert(moved_.end(), woken.begin(), woken.end());
    std::sort(moved_.begin(), moved_.end());
    moved_.erase(std::unique(moved_.begin(), moved_.end()), moved_.end());
    list_stepped();
}

} // namespace flying
