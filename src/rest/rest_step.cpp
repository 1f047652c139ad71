#include <algorithm>
#include <cmath>

#include "rest/rest_engine.hpp"
#include "rest/stopwatch.hpp"

namespace flying {
namespace {

// [rest.step.limits]
/// Looks at who may meet whom, each with the speeds that the last has found.
constexpr int k_most_tries = 4;
/// [ways] Reach of a body that an impact has thrown this far.
constexpr double k_outrun = 1.25;
/// [sizes] Overlap that the last of them may leave, for the next step to end by a rebound; more is ended without one.
constexpr double k_most_overlap = 0x1p-4;
/// [steps] Shorter parts of a step are not halved: a group takes what comes out. Where somebody goes further in a part
/// than this many sizes, a crumb that was hit hard perhaps, parts may be shorter still.
constexpr double k_shortest = 0x1p-7;
constexpr double k_shortest_of_fast = 0x1p-10;
constexpr double k_far = 0x1p-1;
/// [steps] A part that would end at an impact ends by so much before it.
constexpr double k_early = 0x1p-6;
/// Parts that the step of one group is made in, and how many more where somebody goes so far; how often one is parted
/// within another; of a crowd's.
constexpr int k_most_parts_of_step = 128;
constexpr int k_more_parts_of_fast = 512;
constexpr int k_deepest = 200;
constexpr int k_deepest_of_crowd = 3;
// [rest.step.limits]

} // namespace

// [rest.step]
void RestEngine::step()
{
    // [rest.step.nobody]
    if (sleepers_ >= 0) {
        // Nobody is awake, and nobody was since a look found it so
        counts_.asleep += sleepers_;
        ++steps_;
        ++counts_.steps;
        return;
    }
    // [rest.step.nobody]
    Stopwatch watch(options_.seconds);
    // [rest.step.begin]
    span_ = options_.step;
    after_ = 0.0;
    std::fill(outrun_.begin(), outrun_.end(), 0.0);
    list_awake();
    // [rest.step.begin]
    for (int tries = 1;; ++tries) {
        // [rest.step.find]
        measure_reach(awake_);
        if (pairs_.update(bodies_, shapes_, radius_, reach_)) ++counts_.looks;
        watch.stop(seconds_.pairs);

        do collide();
        while (wake_touched());
        watch.stop(seconds_.collide);
        // [rest.step.find]

        gather_groups(awake_);
        for (Group& group : groups_) solve_group(group);
        watch.stop(seconds_.solve);

        // Look again where somebody may meet others than those that were looked at
        is_last_try_ = tries == k_most_tries;
        if (!is_last_try_ && any_outran()) continue;
        // [rest.step.end]
        for (const int k : awake_) whole_reach_[k] = reach_[k];
        save_pairs();
        has_outrun_ = false;
        forget_strays();
        finish_groups(0, {});
        save_parted_pairs();
        make_in_halves(0);
        watch.stop(seconds_.move);
        if (is_last_try_ || !has_outrun_) break;
        go_back();
        // [rest.step.end]
    }
    ++steps_;
    ++counts_.steps;
    if (awake_.empty()) sleepers_ = std::count(asleep_.begin(), asleep_.end(), 1);
}
// [rest.step]

// [rest.step.awake]
void RestEngine::list_awake()
{
    awake_.clear();
    none_sleeps_ = true;
    wakes_.assign(bodies_.size(), 0);
    for (int k = 0; k < static_cast<int>(bodies_.size()); ++k) {
        if (asleep_[k]) {
            ++counts_.asleep;
            none_sleeps_ = false;
        } else if (!bodies_[k].is_static && bodies_[k].is_active) awake_.push_back(k);
    }
    saved_.resize(bodies_.size());
    for (const int k : awake_) wakes_[k] = 1;
    for (const int k : awake_) saved_[k] = {bodies_[k].state, pull_[k], turn_pull_[k], in_crowd_[k]};
}
// [rest.step.awake]

// [rest.step.back]
void RestEngine::save_pairs()
{
    // Only pairs with points have anything to remember, and nobody goes back but where a group that is solved whole outran
    // its reach
    saved_pairs_.clear();
    const auto may_outrun = [](const Group& group) { return is_exact(group) && group.point_count > 0; };
    if (std::none_of(groups_.begin(), groups_.end(), may_outrun)) return;
    int last = -1;
    for (const ContactPoint& c : points_) {
        if (c.pair != last) saved_pairs_.emplace_back(c.pair, pairs_.pairs()[c.pair]);
        last = c.pair;
    }
}

void RestEngine::save_parted_pairs()
{
    // Parts of steps may find points where the whole has found none
    for (const int k : again_[0].pairs) {
        const RestPair& pair = pairs_.pairs()[k];
        if (pair.count == 0) saved_pairs_.emplace_back(k, pair);
    }
}

/// All that the step has changed, as it was when the step began.
void RestEngine::go_back()
{
    forget_legs();
    for (const int k : awake_) {
        bodies_[k].state = saved_[k].state;
        pull_[k] = saved_[k].pull;
        turn_pull_[k] = saved_[k].turn_pull;
        in_crowd_[k] = saved_[k].in_crowd;
        asleep_[k] = still_[k] = 0;
        sleep_group_[k] = -1;
    }
    for (const auto& [index, loads] : saved_pairs_) static_cast<PairLoads&>(pairs_.pairs()[index]) = loads;
    ++counts_.repeated;
}
// [rest.step.back]

// [rest.step.outran]
bool RestEngine::any_outran()
{
    // Whoever an impact has made faster than its reach might meet others than those that were looked at
    bool any = false;
    for (const Group& group : groups_) {
        if (!is_exact(group) || group.point_count == 0) continue;
        for (int k = 0; k < group.member_count; ++k) {
            const int member = members_[group.first_member + k];
            const Mover& now = movers_[member];
            const double way =
                span_ * (std::sqrt(now.v_x * now.v_x + now.v_y * now.v_y) + std::abs(now.spin) * turning_[member]);
            if (!(way > reach_[member]) || !std::isfinite(way)) continue;
            outrun_[member] = k_outrun * way;
            any = true;
        }
    }
    if (!any) return false;
    for (const RestPair& pair : pairs_.pairs()) {
        const double more_a = outrun_[pair.a] - reach_[pair.a];
        const double more_b = outrun_[pair.b] - reach_[pair.b];
        if (pair.count > 0 || !(std::max(more_a, more_b) > 0.0)) continue;
        const double margin = std::max(outrun_[pair.a], reach_[pair.a]) + std::max(outrun_[pair.b], reach_[pair.b]);
        if (look(pair, poses_[pair.a], poses_[pair.b], margin).count > 0) return true;
    }
    return false;
}

void RestEngine::note_outrun(const Group& group)
{
    // The same, of a part of a step
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const BodyState& now = bodies_[member].state;
        const BodyState& old = saved_[member].state;
        const double way = (now.position - old.position).norm() + std::abs(now.angle - old.angle) * turning_[member];
        if (!(way > whole_reach_[member])) continue;
        const double speed = now.velocity.norm() + std::abs(now.spin) * turning_[member];
        outrun_[member] = k_outrun * std::max(way, options_.step * speed);
        has_outrun_ = true;
    }
}
// [rest.step.outran]

// [rest.step.finish]
void RestEngine::finish_groups(int depth, std::span<const int> pairs)
{
    again_.resize(k_deepest + 1);
    Again& again = again_[depth];
    if (depth == 0) parts_left_ = k_most_parts_of_step;
    again.parts.clear();
    again.members.clear();
    again.pairs.clear();
    for (Group& group : groups_) {
        if (is_exact(group) && !group.is_crowd_solved) find_places(group);
        if (is_exact(group) && group.point_count > 0) {
            double overlap = look_at_end(group);
            if (is_to_be_parted(group, depth, overlap)) {
                note_again(group, again);
                continue;
            }
            if (!is_sane(group) || overlap > k_most_overlap) {
                solve_crowd(group);
                overlap = look_at_end(group);
            }
            // What came to overlap in this step, and is pushed apart, may be lifted by more than it can pay for
            const bool is_pushed = overlap > 0.0 && overlap > overlap_at_start(group);
            overlap = put_apart(group, overlap);
            if (is_pushed && !is_crowd(group) && may_be_parted(group, depth) && rises(group)) {
                note_again(group, again);
                continue;
            }
            note_strays(group, depth);
            cut_ways_short(group, overlap);
            if (pay_for_rise(group)) hold_back(group);
        } else if (is_exact(group) && meets_strays(group)) {
            cut_ways_short(group, 0.0);
            if (pay_for_rise(group)) hold_back(group);
        } else if (group.point_count > 0) {
            // Sweeps that have not come to their end, or go ahead of it, may leave more energy than there was
            (void)pay_for_rise(group);
        }
        move_group(group);
        if (depth > 0 || is_exact(group)) note_outrun(group);
    }
    if (!again.parts.empty()) find_pairs_of(again, pairs);
}
// [rest.step.finish]

// [rest.step.again]
bool RestEngine::may_be_parted(const Group& group, int depth) const
{
    const int most = is_crowd(group) ? k_deepest_of_crowd : k_deepest;
    if (depth >= most || group.member_count > options_.most_solved) return false;
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    const bool is_short = parts_left_ <= 0 || span_ <= k_shortest * options_.step;
    if (is_short) {
        const bool is_shortest = parts_left_ <= -k_more_parts_of_fast || span_ <= k_shortest_of_fast * options_.step;
        const bool goes_far = std::any_of(members.begin(), members.end(), [&](int member) {
            return shift_[member].norm() + std::abs(turn_[member]) * radius_[member] > k_far * radius_[member];
        });
        if (is_shortest || !goes_far) return false;
    }
    return true;
}

bool RestEngine::is_to_be_parted(const Group& group, int depth, double overlap) const
{
    if (!may_be_parted(group, depth)) return false;

    // Parts of a step of a crowd are parted for much overlap only: each solves for all of the crowd
    if (is_crowd(group) && depth > 0) return !is_sane(group) || overlap > k_most_overlap;
    return !is_fair(group, overlap);
}

void RestEngine::note_again(const Group& group, Again& again)
{
    const int part = static_cast<int>(again.parts.size());
    again.starts.resize(bodies_.size());
    // The moment of an impact is foreseen by what the bodies did before, and may come a little sooner: end a little before
    // it, for what is foreseen over a short way is right
    double impact = first_impact(group);
    const double early = k_early * options_.step;
    if (impact < span_ && impact > 2.0 * early) impact -= early;
    again.parts.push_back(
        {static_cast<int>(again.members.size()), group.member_count, 0, 0, impact < span_ ? impact : 0.5 * span_});
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        again.members.push_back(member);
        part_of_[member] = part;
        const BodyState& state = bodies_[member].state;
        again.starts[member] = {state.position, state.angle, reach_[member]};
    }
}

void RestEngine::find_pairs_of(Again& again, std::span<const int> pairs)
{
    // A pair belongs to the part that both its bodies belong to, or the one that moves
    const auto part_of = [&](const RestPair& pair) {
        const int a = part_of_[pair.a];
        const int b = part_of_[pair.b];
        if (bodies_[pair.a].is_static) return b;
        if (bodies_[pair.b].is_static) return a;
        return a == b ? a : -1;
    };
    const auto each = [&](auto&& act) {
        const int count = static_cast<int>(pairs.empty() ? pairs_.pairs().size() : pairs.size());
        for (int k = 0; k < count; ++k) {
            const int pair = pairs.empty() ? k : pairs[k];
            const int part = part_of(pairs_.pairs()[pair]);
            if (part >= 0) act(pair, again.parts[part]);
        }
    };
    each([](int, Again::Part& part) { ++part.pair_count; });
    int first = 0;
    for (Again::Part& part : again.parts) {
        part.first_pair = first;
        first += part.pair_count;
        part.pair_count = 0;
    }
    again.pairs.resize(first);
    each([&](int pair, Again::Part& part) { again.pairs[part.first_pair + part.pair_count++] = pair; });
    for (const int member : again.members) part_of_[member] = -1;
}
// [rest.step.again]

// [rest.step.halves]
void RestEngine::make_in_halves(int depth)
{
    const double whole = span_;
    const double after_whole = after_;
    for (std::size_t k = 0; k < again_[depth].parts.size(); ++k) {
        const Again::Part part = again_[depth].parts[k];
        const std::span<const int> members = std::span(again_[depth].members).subspan(part.first_member, part.member_count);
        const std::span<const int> pairs = std::span(again_[depth].pairs).subspan(part.first_pair, part.pair_count);
        if (depth == 0) parts_left_ = k_most_parts_of_step;
        parts_left_ -= 2;
        double before = whole;
        double left = whole;
        for (const double half : {part.first_half, whole - part.first_half}) {
            span_ = half;
            left -= half;
            after_ = after_whole + left;
            scale_loads(pairs, half / before);
            before = half;
            measure_reach(members);
            found_.clear();
            for (const int pair : pairs) collide_pair(pair);
            gather_groups(members);
            for (Group& group : groups_) solve_group(group);
            finish_groups(depth + 1, pairs);
            make_in_halves(depth + 1);
        }
        span_ = whole;
        after_ = after_whole;
        scale_loads(pairs, whole / before);
        ++counts_.halved;
    }
    again_[depth].parts.clear();
}

void RestEngine::scale_loads(std::span<const int> pairs, double factor)
{
    // Impulses of half the time; by a power of two, so that no bit is lost on the way there and back
    for (const int k : pairs) {
        RestPair& pair = pairs_.pairs()[k];
        for (int i = 0; i < pair.count; ++i) {
            pair.normal[i] *= factor;
            pair.tangent[i] *= factor;
        }
    }
}
// [rest.step.halves]

} // namespace flying
