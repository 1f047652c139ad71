#include <algorithm>
#include <cmath>

#include "collide/separating_axis.hpp"
#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {


/// [sizes] Where two come nearer by less, parts of theirs that had no point are not looked at.
constexpr double k_short_way = 0x1p-10;
/// [rad] Turn within a step that a group with contacts may make.
constexpr double k_fair_turn = 0.25;
/// [radii] Push that may take off overlap.
constexpr double k_most_push = 0.5;
/// [energies] Rise that slowing down may end; where it is more, the step is made in halves.
constexpr double k_fair_rise = 0x1p-8;
/// Rounds of taking off overlap: each leaves about the square of what the last has found.
constexpr int k_rounds = 4;


} // namespace


bool RestEngine::may_overlap(const ContactPoint& c) const
{
    // A gap along a fixed normal is never more than the distance; turning may bring anything along it by its whole arc
    const double way = c.n_x * (shift_[c.b].x() - shift_[c.a].x()) + c.n_y * (shift_[c.b].y() - shift_[c.a].y());
    const double arcs = std::abs(turn_[c.a]) * turning_[c.a] + std::abs(turn_[c.b]) * turning_[c.b];
    return c.gap + way - arcs < -touch_gap(c.a, c.b);
}



double RestEngine::look_at_end(const Group& group)
{
    place_points_.clear();
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const bool any_nearer = std::any_of(points.begin(), points.end(), [&](const ContactPoint& c) { return comes_nearer(c.a, c.b); });
    const bool may_any = std::any_of(points.begin(), points.end(), [&](const ContactPoint& c) { return may_overlap(c); });
    if (!may_any && !any_nearer) return 0.0;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const BodyState& s = bodies_[member].state;
        next_poses_[member] = {s.position + shift_[member], Rotation::of(s.angle + turn_[member])};
    }
    list_pairs_of(points);
    const auto is_overlap = [&](int index) {
        const RestPair& pair = pairs_.pairs()[index];
        return comes_nearer(pair.a, pair.b) && overlap_at_end(pair).separation < 0.0;
    };
    if (!may_any && std::none_of(looked_at_.begin(), looked_at_.end(), is_overlap)) return 0.0;
    double worst = 0.0;
    for (const int pair : looked_at_) worst = std::max(worst, look_at_pair(pair));
    return worst;
}

/// Two that come nearer to each other by so much may come to overlap where they had no point.
bool RestEngine::comes_nearer(int a, int b) const
{
    const double nearer =
        (shift_[b] - shift_[a]).norm() + std::abs(turn_[a]) * turning_[a] + std::abs(turn_[b]) * turning_[b];
    return nearer > k_short_way * std::min(radius_[a], radius_[b]);
}

/// The pairs that points belong to, and where the two come nearer to each other those of all their parts.
void RestEngine::list_pairs_of(std::span<const ContactPoint> points)
{
    looked_at_.clear();
    const std::span<const RestPair> pairs = pairs_.pairs();
    for (const ContactPoint& c : points) {
        if (!looked_at_.empty() && looked_at_.back() == c.pair) continue;
        const bool has_parts = shapes_[c.a].parts.size() + shapes_[c.b].parts.size() > 2;
        const bool all = has_parts && comes_nearer(c.a, c.b);
        // The pairs of all parts of the two stand together
        const auto is_theirs = [&](int pair) { return pairs[pair].a == c.a && pairs[pair].b == c.b; };
        int first = c.pair;
        int end = c.pair + 1;
        while (all && first > 0 && is_theirs(first - 1)) --first;
        while (all && end < static_cast<int>(pairs.size()) && is_theirs(end)) ++end;
        for (int pair = first; pair < end; ++pair) looked_at_.push_back(pair);
    }
    std::sort(looked_at_.begin(), looked_at_.end());
    looked_at_.erase(std::unique(looked_at_.begin(), looked_at_.end()), looked_at_.end());
}

/// How two polygons part by the shortest way where they overlap as the step ends; separation 0 where they don't.
Contact RestEngine::overlap_at_end(const RestPair& pair) const
{
    Contact contact;
    const ConvexPart& part_a = shapes_[pair.a].parts[pair.part_a];
    const ConvexPart& part_b = shapes_[pair.b].parts[pair.part_b];
    const auto* a = std::get_if<Polygon>(&part_a.shape);
    const auto* b = std::get_if<Polygon>(&part_b.shape);
    if (!a || !b) return contact;
    const Pose& pose_a = next_poses_[pair.a];
    const Pose& pose_b = next_poses_[pair.b];
    const Pose a_from_b = relative_pose(pose_a, pose_b);
    const double clear = part_a.radius + part_b.radius;
    if ((a_from_b * part_b.centre - part_a.centre).squaredNorm() > clear * clear) return contact;
    const Axis axis = greatest_separation(*a, *b, a_from_b);
    if (!(axis.separation < -touch_gap(pair.a, pair.b))) return contact;
    const bool of_a = axis.owner == Owner::a;
    contact.separation = axis.separation;
    contact.normal = of_a ? Vec2(pose_a.rotation * a->edges()[axis.edge].normal)
                          : Vec2(-(pose_b.rotation * b->edges()[axis.edge].normal));
    contact.point = of_a ? pose_b * b->vertices()[axis.vertex] : pose_a * a->vertices()[axis.vertex];
    return contact;
}

/// The points of a pair as the step ends, and how much it overlaps.  [sizes]
double RestEngine::look_at_pair(int index)
{
    const RestPair& pair = pairs_.pairs()[index];
    const double size = std::min(radius_[pair.a], radius_[pair.b]);
    const Manifold manifold = look(pair, next_poses_[pair.a], next_poses_[pair.b], rest_tolerance::k_watch * size);
    ++counts_.manifolds;
    double worst = 0.0;
    const auto add = [&](const Contact& contact) {
        ContactPoint& c = place_points_.emplace_back();
        c.a = pair.a;
        c.b = pair.b;
        c.pair = index;
        c.feature = contact.feature;
        set_arms(c, contact.normal, contact.point - next_poses_[pair.a].position,
                 contact.point - next_poses_[pair.b].position);
        c.bound = -contact.separation;
        const double depth = -contact.separation - touch_gap(pair.a, pair.b);
        worst = std::max(worst, depth / size);
    };
    for (int k = 0; k < manifold.count; ++k) add(manifold.contacts[k]);
    if (worst > 0.0 || !comes_nearer(pair.a, pair.b)) return worst;

    // What sticks out beyond the ends of the edge that it lies deepest under is clipped there
    const Contact clipped = overlap_at_end(pair);
    if (clipped.separation < 0.0) add(clipped);
    return worst;
}



/// Moves bodies out of what they overlap: the same conditions for places as for velocities, least by the masses, without
/// friction. It adds no velocity.
void RestEngine::put_apart(const Group& group, double overlap)
{
    if (overlap <= 0.0) return;
    ++counts_.projected;
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    for (int round = 0; round < k_rounds && overlap > 0.0; ++round) {
        double touch = touch_gap(place_points_[0].a, place_points_[0].b);
        for (const ContactPoint& c : place_points_) touch = std::min(touch, touch_gap(c.a, c.b));
        for (const int member : members) {
            place_movers_[member] = movers_[member];
            place_movers_[member].v_x = place_movers_[member].v_y = place_movers_[member].spin = 0.0;
            shift_before_[member] = shift_[member];
            turn_before_[member] = turn_[member];
        }
        find_pushes(group, 0.125 * touch);
        bool too_far = false;
        for (const int member : members) {
            const Mover& mover = place_movers_[member];
            const double push = std::abs(mover.v_x) + std::abs(mover.v_y) + std::abs(mover.spin) * radius_[member];
            too_far = too_far || !(push <= k_most_push * radius_[member]);
            shift_[member] += Vec2(mover.v_x, mover.v_y);
            turn_[member] += mover.spin;
        }
        const double after = too_far ? overlap : look_at_end(group);
        if (!(after < overlap)) {
            for (const int member : members) {
                shift_[member] = shift_before_[member];
                turn_[member] = turn_before_[member];
            }
            return;
        }
        overlap = after;
    }
}

/// Pushes that take off overlap.
void RestEngine::find_pushes(const Group& group, double tolerance)
{
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    if (is_heap(group)) sweep_heap(group, place_movers_, place_points_, tolerance);
    else solver_.solve(place_movers_, members, place_points_, tolerance);
}



/// Deepest overlap that the step has begun with.  [sizes]
double RestEngine::overlap_at_start(const Group& group) const
{
    double worst = 0.0;
    for (const ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        worst = std::max(worst, -c.gap / std::min(radius_[c.a], radius_[c.b]));
    }
    return worst;
}

/// When a load that wanes evenly comes to its end: where it is less than a third of what it was over the step before, that
/// is within this one; 0 where none does.  [s]
double RestEngine::end_of_load(const Group& group) const
{
    double first = span_;
    for (const ContactPoint& c : std::span(points_).subspan(group.first_point, group.point_count)) {
        const RestPair& pair = pairs_.pairs()[c.pair];
        const auto* own = std::find(pair.feature, pair.feature + pair.count, c.feature);
        const double before = own != pair.feature + pair.count ? pair.normal[own - pair.feature] : 0.0;
        if (!(3.0 * c.normal < before)) continue;

        // Both are means, and stand for the middles of their steps; of one that has ended before that, less is known
        const double share = c.normal > 0.0 ? 0.5 + c.normal / (before - c.normal) : 0.25;
        first = std::min(first, share * span_);
    }
    return first < span_ ? first : 0.0;
}

/// The step may end as it was found: with little overlap or no more than there was, little turning, and no more energy
/// than the limiter may take off.
bool RestEngine::is_fair(const Group& group, double overlap) const
{
    if (overlap > rest_tolerance::k_fair_overlap && overlap > overlap_at_start(group)) return false;
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        if (!(std::abs(turn_[member]) * turning_[member] <= k_fair_turn * radius_[member])) return false;
    }
    const Gain gain = gain_of(group);
    return gain.gained <= k_fair_rise * gain.scale;
}


} // namespace flying
