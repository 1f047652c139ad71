#include <algorithm>
#include <cmath>

#include "rest/rest_engine.hpp"
#include "rest/stopwatch.hpp"

namespace flying {
namespace {


/// [steps] Shorter parts of a step are not cut again: an island takes what comes out.
constexpr double k_shortest = 0x1p-10;
/// Parts that the step of one island is made in, where its impacts have moments of their own, and where they have not;
/// how often one is cut within another.
constexpr int k_most_parts = 64;
constexpr int k_most_parts_of_many = 8;
constexpr int k_deepest = 64;
/// Bodies of the largest island whose step is cut at all.
constexpr int k_most_cut = 64;


} // namespace


void RestEngine::step()
{
    // [rest.step.nobody]
    if (sleepers_ >= 0) {
        // Nothing is awake, and nothing was since a look found it so
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
    list_awake();
    measure_reach(awake_);
    if (pairs_.update(bodies_, shapes_, radius_, reach_)) ++counts_.looks;
    watch.stop(seconds_.pairs);
    // [rest.step.begin]

    // [rest.step.find]
    do collide();
    while (wake_touched());
    watch.stop(seconds_.collide);
    // [rest.step.find]

    // [rest.step.end]
    gather_groups(awake_);
    parts_made_ = 0;
    for (Group& group : groups_) solve_group(group, 0);
    watch.stop(seconds_.solve);

    finish_groups(0, {});
    make_parts(0);
    watch.stop(seconds_.move);
    // [rest.step.end]
    ++steps_;
    ++counts_.steps;
    if (awake_.empty()) sleepers_ = std::count(asleep_.begin(), asleep_.end(), 1);
}



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



void RestEngine::finish_groups(int depth, std::span<const int> pairs)
{
    again_.resize(k_deepest + 1);
    Again& again = again_[depth];
    again.parts.clear();
    again.members.clear();
    again.pairs.clear();
    for (Group& group : groups_) {
        if (group.cut_at > 0.0) {
            note_again(group, again);
            continue;
        }
        if (group.is_exact) find_places(group);
        if (group.in_turn) group.cut_at = missed_impact(group);
        if (group.in_turn && group.has_ways && group.cut_at == 0.0 && span_ == options_.step) group.cut_at = end_of_load(group);
        if (group.cut_at > 0.0) {
            note_again(group, again);
            continue;
        }
        if (group.is_exact && group.point_count > 0) {
            const double overlap = look_at_end(group);
            if (may_be_cut(group, depth) && !is_fair(group, overlap)) {
                group.cut_at = 0.5 * span_;
                note_again(group, again);
                continue;
            }
            put_apart(group, overlap);
        }
        if (group.point_count > 0) limit_energy(group);
        move_group(group);
    }
    if (!again.parts.empty()) find_pairs_of(again, pairs);
}



bool RestEngine::may_be_cut(const Group& group, int depth) const
{
    const int most = strikes_at_start(group) ? k_most_parts_of_many : k_most_parts;
    return group.member_count <= k_most_cut && depth < k_deepest && parts_made_ < most && span_ > k_shortest * options_.step;
}

void RestEngine::note_again(const Group& group, Again& again)
{
    const int part = static_cast<int>(again.parts.size());
    again.parts.push_back({static_cast<int>(again.members.size()), group.member_count, 0, 0, group.cut_at});
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        again.members.push_back(member);
        part_of_[member] = part;
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
            // The list may hold more, which depends on when it was made
            if (part >= 0 && is_near_[pair]) act(pair, again.parts[part]);
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



/// The steps of islands that end early, at a moment each: the part up to there, and what is left.
void RestEngine::make_parts(int depth)
{
    const double whole = span_;
    const double after_whole = after_;
    for (std::size_t k = 0; k < again_[depth].parts.size(); ++k) {
        const Again::Part part = again_[depth].parts[k];
        const std::span<const int> members = std::span(again_[depth].members).subspan(part.first_member, part.member_count);
        const std::span<const int> pairs = std::span(again_[depth].pairs).subspan(part.first_pair, part.pair_count);
        if (depth == 0) parts_made_ = 0;
        double before = whole;
        double left = whole;
        for (const double length : {part.cut_at, whole - part.cut_at}) {
            if (!(length > 0.0)) continue;
            ++parts_made_;
            span_ = length;
            left -= length;
            after_ = after_whole + left;
            scale_loads(pairs, length / before);
            before = length;
            measure_reach(members);
            found_.clear();
            for (const int pair : pairs) (void)collide_pair(pair);
            gather_groups(members);
            for (Group& group : groups_) solve_group(group, depth + 1);
            finish_groups(depth + 1, pairs);
            make_parts(depth + 1);
        }
        span_ = whole;
        after_ = after_whole;
        scale_loads(pairs, whole / before);
        ++counts_.parts;
    }
    again_[depth].parts.clear();
}

void RestEngine::scale_loads(std::span<const int> pairs, double factor)
{
    // Impulses of another length of time
    if (factor == 1.0) return;
    for (const int k : pairs) {
        RestPair& pair = pairs_.pairs()[k];
        for (int i = 0; i < pair.count; ++i) {
            pair.normal[i] *= factor;
            pair.tangent[i] *= factor;
        }
    }
}


} // namespace flying
