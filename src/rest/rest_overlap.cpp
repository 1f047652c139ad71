#include <algorithm>
#include <cmath>

#include "collide/separating_axis.hpp"
#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

// [rest.overlap.limits]
/// [sizes] Where two come nearer by less, parts of theirs that had no point are not looked at.
constexpr double k_short_way = 0x1p-10;
/// [rad] Turn within a step that a group with contacts may make.
constexpr double k_fair_turn = 0.25;
/// [ways] Longer ways than speeds before and after explain come of rounding.
constexpr double k_sane_way = 2.0;
/// [radii] Push that may take off overlap.
constexpr double k_most_push = 0.5;
/// Bodies of the largest group whose step is cut where an impact falls into it.
constexpr int k_most_cut = 12;
/// [energies] Rise that slowing down may end; where it is more, the step is made in halves.
constexpr double k_fair_rise = 0x1p-8;
/// Rounds of taking off overlap: each leaves about the square of what the last has found.
constexpr int k_rounds = 4;
// [rest.overlap.limits]

} // namespace

// [rest.overlap.may]
bool RestEngine::may_overlap(const ContactPoint& c) const
{
    // A gap along a fixed normal is never more than the distance; turning may bring anything along it by its whole arc
    if (c.left != span_) return true;
    const double way = c.n_x * (shift_[c.b].x() - shift_[c.a].x()) + c.n_y * (shift_[c.b].y() - shift_[c.a].y());
    const double arcs = std::abs(turn_[c.a]) * turning_[c.a] + std::abs(turn_[c.b]) * turning_[c.b];
    return c.gap + way - arcs < -touch_gap(c.a, c.b);
}
// [rest.overlap.may]

// [rest.overlap.look]
double RestEngine::look_at_end(const Group& group)
{
    place_points_.clear();
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.all_points);
    const auto nearer = [&](const ContactPoint& c) { return comes_nearer(c.a, c.b); };
    const bool any_nearer = std::any_of(points.begin(), points.end(), nearer);
    // A crowd's gaps are those that were foreseen, along the normals of later moments
    const bool may_any = (group.is_crowd_solved && any_nearer) ||
                         std::any_of(points.begin(), points.end(), [&](const ContactPoint& c) { return may_overlap(c); });
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
// [rest.overlap.look]

// [rest.overlap.apart]
double RestEngine::put_apart(const Group& group, double overlap)
{
    if (overlap <= 0.0) return overlap;
    ++counts_.placed;
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    for (int round = 0; round < k_rounds && overlap > 0.0; ++round) {
        // The same conditions for places as for velocities: apart, least by the masses, and no friction
        double touch = touch_gap(place_points_[0].a, place_points_[0].b);
        for (const ContactPoint& c : place_points_) touch = std::min(touch, touch_gap(c.a, c.b));
        for (const int member : members) {
            place_movers_[member] = movers_[member];
            place_movers_[member].v_x = place_movers_[member].v_y = place_movers_[member].spin = 0.0;
            shift_before_[member] = shift_[member];
            turn_before_[member] = turn_[member];
        }
        find_pushes(group, 0.125 * touch);
        for (const int member : members) {
            const Mover& mover = place_movers_[member];
            shift_[member] += Vec2(mover.v_x, mover.v_y);
            turn_[member] += mover.spin;
        }
        const bool too_far = std::any_of(members.begin(), members.end(), [&](int member) {
            const Mover& mover = place_movers_[member];
            const double push = std::abs(mover.v_x) + std::abs(mover.v_y) + std::abs(mover.spin) * radius_[member];
            return !(push <= k_most_push * radius_[member]);
        });
        const double after = too_far ? overlap : look_at_end(group);
        if (after < overlap) {
            overlap = after;
            continue;
        }
        for (const int member : members) {
            shift_[member] = shift_before_[member];
            turn_[member] = turn_before_[member];
        }
        break;
    }
    return overlap;
}
// [rest.overlap.apart]

// [rest.overlap.sane]
bool RestEngine::is_sane(const Group& group) const
{
    // Great impulses that nearly balance leave small speeds and may leave long ways
    if (!is_crowd(group) && !group.is_content) return false;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const Mover& old = before_[member];
        const Mover& now = movers_[member];
        const double speeds = std::abs(old.v_x) + std::abs(old.v_y) + std::abs(now.v_x) + std::abs(now.v_y);
        const double spins = std::abs(old.spin) + std::abs(now.spin);
        const double field = span_ * field_[member].cwiseAbs().sum();
        const double most = span_ * (speeds + spins * radius_[member] + field);
        const double way = shift_[member].norm() + std::abs(turn_[member]) * radius_[member];
        if (!(way <= k_sane_way * most + rest_tolerance::k_touch * radius_[member])) return false;
    }
    return true;
}
// [rest.overlap.sane]

// [rest.overlap.fair]
double RestEngine::overlap_at_start(const Group& group) const
{
    double worst = 0.0;
    for (int k = 0; k < group.all_points; ++k) {
        const ContactPoint& c = points_[group.first_point + k];
        if (c.left == span_) worst = std::max(worst, -c.gap / std::min(radius_[c.a], radius_[c.b]));
    }
    return worst;
}

bool RestEngine::is_clear(const Group& group, double overlap) const
{
    return is_sane(group) && (overlap <= rest_tolerance::k_fair_overlap || overlap <= overlap_at_start(group));
}

double RestEngine::first_impact(const Group& group) const
{
    // Where one contact is struck while others bear, the others bear something else before and after
    double first = span_;
    bool all_at_once = true;
    double common = -1.0;
    double last = 0.0;
    for (int k = 0; k < group.point_count; ++k) {
        const ContactPoint& c = points_[group.first_point + k];
        const RestPair& pair = pairs_.pairs()[c.pair];
        const bool bore = c.left == span_ && (pair.normal[0] > 0.0 || pair.normal[1] > 0.0);
        if (!(c.normal > 0.0) && !bore) continue;

        // A corner that strikes while the other one of its pair lies or bears shares its moment, not its past
        if (c.lay) all_at_once = false;
        if (c.left < span_ && pair.count == 2) {
            const int own = pair.feature[0] == c.feature ? 0 : 1;
            if (pair.normal[own] == 0.0 && pair.normal[1 - own] > 0.0) all_at_once = false;
        }
        if (common < 0.0) common = c.left;
        all_at_once = all_at_once && c.left == common;
        if (c.left < span_) first = std::min(first, span_ - c.left);
        if (c.normal > 0.0 && c.left < span_) last = std::max(last, span_ - c.left);
    }

    // A later impact was foreseen as if nothing were struck before
    for (int k = 0; k < group.point_count; ++k) {
        const ContactPoint& c = points_[group.first_point + k];
        const double moment = span_ - c.left;
        if (c.normal > 0.0 || moment >= last) continue;
        if (moment == 0.0) {
            const double way = c.gap + last * normal_speed(c, before_[c.a], before_[c.b]);
            if (way < -touch_gap(c.a, c.b)) all_at_once = false;
            continue;
        }
        first = std::min(first, moment);
        all_at_once = false;
    }
    return all_at_once ? span_ : first;
}

bool RestEngine::is_fair(const Group& group, double overlap) const
{
    if (!is_clear(group, overlap)) return false;
    if (group.member_count <= k_most_cut && first_impact(group) < span_) return false;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        if (!(std::abs(turn_[member]) * turning_[member] <= k_fair_turn * radius_[member])) return false;
    }
    return !rises(group);
}

/// By more than slowing down may end.
bool RestEngine::rises(const Group& group) const
{
    const Gain gain = gain_of(group);
    return !(gain.gained <= k_fair_rise * gain.scale);
}
// [rest.overlap.fair]

// [rest.energy.gain]
RestEngine::Gain RestEngine::gain_of(const Group& group) const
{
    Gain gain;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const Mover& old = before_[member];
        const Mover& now = movers_[member];
        const double before =
            0.5 * ((old.v_x * old.v_x + old.v_y * old.v_y) / old.inv_mass + old.spin * old.spin / old.inv_moment);
        const double after =
            0.5 * ((now.v_x * now.v_x + now.v_y * now.v_y) / now.inv_mass + now.spin * now.spin / now.inv_moment);
        const double work = work_of_field(member) / now.inv_mass;
        gain.gained += (after - before) - work;
        const Vec2& field = field_[member];
        const double through_field = field.cwiseProduct(shift_[member]).cwiseAbs().sum();
        const double in_a_step = (span_ * field).squaredNorm(); // the solve's rounding is in proportion to it
        gain.scale += after + before + (through_field + in_a_step) / now.inv_mass;
    }
    return gain;
}
// [rest.energy.gain]

// [rest.energy.pay]
bool RestEngine::pay_for_rise(const Group& group)
{
    const Gain gain = gain_of(group);
    if (gain.gained <= rest_tolerance::k_rounding * gain.scale) return false;
    ++counts_.paid;

    // A group that leans on what is static slows down as it is; others about their centre of mass, if that is enough
    bool leans = false;
    for (int k = 0; k < group.point_count; ++k) {
        const ContactPoint& c = points_[group.first_point + k];
        leans = leans || (c.normal > 0.0 && (!is_moved(c.a) || !is_moved(c.b)));
    }
    if (!leans && slow_down(group, gain.gained, common_velocity(group))) return false;
    if (slow_down(group, gain.gained, Vec2::Zero())) return false;

    // Who has nothing left to pay with rises no further than the motion before would have carried it, and stays if it stood
    const Gain rest = gain_of(group);
    double lift = 0.0;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        lift -= work_of_field(member) / movers_[member].inv_mass;
    }
    const double part = rest.gained < lift && !stood(group) ? 1.0 - rest.gained / lift : 0.0;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        shift_[member] *= part;
        turn_[member] *= part;
    }
    return true;
}

Vec2 RestEngine::common_velocity(const Group& group) const
{
    double mass = 0.0;
    Vec2 momentum = Vec2::Zero();
    for (int k = 0; k < group.member_count; ++k) {
        const Mover& now = movers_[members_[group.first_member + k]];
        mass += 1.0 / now.inv_mass;
        momentum += Vec2(now.v_x, now.v_y) / now.inv_mass;
    }
    return momentum / mass;
}

/// Take energy out of the motion beyond a common one; all that there is, and false, where it is not enough.
bool RestEngine::slow_down(const Group& group, double by, const Vec2& common)
{
    double energy = 0.0;
    for (int k = 0; k < group.member_count; ++k) {
        const Mover& now = movers_[members_[group.first_member + k]];
        const Vec2 own = Vec2(now.v_x, now.v_y) - common;
        energy += 0.5 * (own.squaredNorm() / now.inv_mass + now.spin * now.spin / now.inv_moment);
    }
    const bool is_enough = energy > by;
    if (!is_enough && !common.isZero(0.0)) return false;
    const double share = is_enough ? std::sqrt(1.0 - by / energy) : 0.0;
    for (int k = 0; k < group.member_count; ++k) {
        Mover& now = movers_[members_[group.first_member + k]];
        now.v_x = common.x() + share * (now.v_x - common.x());
        now.v_y = common.y() + share * (now.v_y - common.y());
        now.spin *= share;
    }
    return is_enough;
}
// [rest.energy.pay]

} // namespace flying
