#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

// [rest.strays.limits]
/// Bisections of a way that leads into an overlap.
constexpr int k_way_halvings = 10;
/// [sizes] Nobody is held for less.
constexpr double k_no_limit = std::numeric_limits<double>::infinity();
// [rest.strays.limits]

} // namespace

// [rest.strays]
/// Who gets further by this than was reckoned with when its group was made, or any that this is a part of.
void RestEngine::note_strays(const Group& group, int depth)
{
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        if (is_stray_[member]) continue;
        bool strays = !(shift_[member].norm() + std::abs(turn_[member]) * turning_[member] <= reach_[member]);
        for (int level = 0; level < depth && !strays; ++level) {
            const Again::Start& start = again_[level].starts[member];
            strays = !(way_from(start.position, start.angle, member) <= start.reach);
        }
        if (!strays) continue;
        is_stray_[member] = 1;
        strays_.push_back(member);
        for (int pair = 0; pair < static_cast<int>(pairs_.pairs().size()); ++pair) {
            const RestPair& with = pairs_.pairs()[pair];
            if (with.a != member && with.b != member) continue;
            const int other = with.a == member ? with.b : with.a;
            if (is_stray_[other]) continue; // it is among its pairs
            is_near_stray_[other] = 1;
            stray_pairs_.push_back(pair);
        }
    }
}

void RestEngine::forget_strays()
{
    if (strays_.empty()) return;
    std::fill(is_stray_.begin(), is_stray_.end(), 0);
    std::fill(is_near_stray_.begin(), is_near_stray_.end(), 0);
    strays_.clear();
    stray_pairs_.clear();
}

/// How far a body has got as the step ends.  [m]
double RestEngine::way_from(const Vec2& position, double angle, int body) const
{
    const BodyState& now = bodies_[body].state;
    return (now.position + shift_[body] - position).norm() + std::abs(now.angle + turn_[body] - angle) * turning_[body];
}

bool RestEngine::meets_strays(const Group& group) const
{
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    return !strays_.empty() && std::any_of(members.begin(), members.end(),
                                           [&](int member) { return is_stray_[member] || is_near_stray_[member]; });
}

/// How much the strays of a group overlap with anybody, or others with strays; infinite where somebody leaves what was
/// looked at, and nobody will look again. Who overlaps by more than `most` is held.  [sizes]
double RestEngine::overlap_outside(const Group& group, Moment moment, double most)
{
    if (!meets_strays(group)) return 0.0;
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    for (const int member : members) is_inside_[member] = 1;
    double worst = 0.0;
    for (const int index : stray_pairs_) {
        const RestPair& pair = pairs_.pairs()[index];
        if (!is_inside_[pair.a] && !is_inside_[pair.b]) continue;
        const auto pose = [&](int body) {
            const BodyState& s = bodies_[body].state;
            if (!is_inside_[body] || moment == Moment::start) return pose_of(s);
            return Pose{s.position + shift_[body], Rotation::of(s.angle + turn_[body])};
        };
        const Manifold manifold = look(pair, pose(pair.a), pose(pair.b), 0.0);
        double depth = 0.0;
        for (int k = 0; k < manifold.count; ++k) depth = std::max(depth, -manifold.contacts[k].separation);
        depth /= std::min(radius_[pair.a], radius_[pair.b]);
        worst = std::max(worst, depth);
        if (depth > most) held_[pair.a] = held_[pair.b] = 1;
    }
    // Beyond what the whole step has looked at there may be anybody
    for (const int member : members) {
        is_inside_[member] = 0;
        if (!is_last_try_ || moment == Moment::start) continue;
        const BodyState& old = saved_[member].state;
        if (way_from(old.position, old.angle, member) <= whole_reach_[member]) continue;
        worst = k_no_limit;
        if (most < k_no_limit) held_[member] = 1;
    }
    return worst;
}
// [rest.strays]

// [rest.overlap.short]
/// More than that a group may not overlap as the step ends.  [sizes]
double RestEngine::most_overlap(const Group& group, double overlap)
{
    double most = rest_tolerance::k_fair_overlap;
    if (overlap <= most) return most;
    most = std::max(most, overlap_outside(group, Moment::start, k_no_limit));
    if (!group.is_crowd_solved) return std::max(most, overlap_at_start(group));

    // A crowd's gaps are no longer those of the start
    int last = -1;
    for (const ContactPoint& c : std::span(points_).subspan(group.first_point, group.all_points)) {
        if (c.pair == last) continue;
        last = c.pair;
        const Manifold manifold = look(pairs_.pairs()[c.pair], poses_[c.a], poses_[c.b], 0.0);
        ++counts_.manifolds;
        const double size = std::min(radius_[c.a], radius_[c.b]);
        for (int k = 0; k < manifold.count; ++k) most = std::max(most, -manifold.contacts[k].separation / size);
    }
    return most;
}

/// overlap  that the group ends with, by its own points  [sizes]
void RestEngine::cut_ways_short(const Group& group, double overlap)
{
    // Where nothing has brought a group to where it overlaps no more than before, whoever does goes as far only as they
    // don't; and who then overlaps with them
    overlap = std::max(overlap, overlap_outside(group, Moment::end, k_no_limit));
    const double most = most_overlap(group, overlap);
    if (overlap <= most) return;
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    for (const int member : members) {
        shift_before_[member] = shift_[member];
        turn_before_[member] = turn_[member];
        held_[member] = 0;
    }
    std::ptrdiff_t before = -1;
    for (std::ptrdiff_t held = 0; overlap > most && held > before;) {
        before = held;
        for (const ContactPoint& c : place_points_) {
            const bool is_deep = c.bound - touch_gap(c.a, c.b) > most * std::min(radius_[c.a], radius_[c.b]);
            if (is_deep) held_[c.a] = held_[c.b] = 1;
        }
        overlap_outside(group, Moment::end, most);
        overlap = go_part_of_way(group, 0.0);
        held = std::count_if(members.begin(), members.end(), [&](int member) { return held_[member] != 0; });
    }
    go_as_far(group, most);
}

/// Those who are held go as far as the group overlaps by no more than `most`.
void RestEngine::go_as_far(const Group& group, double most)
{
    ++counts_.held;
    double low = 0.0;
    double high = 1.0;
    for (int k = 0; k < k_way_halvings; ++k) {
        const double middle = 0.5 * (low + high);
        (go_part_of_way(group, middle) <= most ? low : high) = middle;
    }
    go_part_of_way(group, low);
}

/// Those who are held go a share of their ways; the overlap that this leaves.  [sizes]
double RestEngine::go_part_of_way(const Group& group, double share)
{
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        if (!held_[member]) continue;
        shift_[member] = share * shift_before_[member];
        turn_[member] = share * turn_before_[member];
    }
    const double within = look_at_end(group);
    return std::max(within, overlap_outside(group, Moment::end, k_no_limit));
}
// [rest.overlap.short]

// [rest.energy.hold]
void RestEngine::hold_back(const Group& group)
{
    // A part of a push out of an overlap may be worse than none: then all go as far together as they overlap no more
    // than before
    const double overlap = std::max(look_at_end(group), overlap_outside(group, Moment::end, k_no_limit));
    const double most = most_overlap(group, overlap);
    if (overlap <= most) return;
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    for (const int member : members) {
        shift_before_[member] = shift_[member];
        turn_before_[member] = turn_[member];
        held_[member] = 1;
    }
    go_as_far(group, most);

    // What the field did not do on the way that is left out is paid for; who has less than that stays
    const Gain gain = gain_of(group);
    if (gain.gained <= rest_tolerance::k_rounding * gain.scale) return;
    if (!slow_down(group, gain.gained, Vec2::Zero())) go_part_of_way(group, 0.0);
}
// [rest.energy.hold]

} // namespace flying
