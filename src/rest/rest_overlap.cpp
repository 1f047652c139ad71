#include <algorithm>
#include <cmath>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

// [rest.overlap.limits]
/// [sizes] Overlap at the end of a step that is taken off; where it is more, the step is made in halves.
constexpr double k_fair_overlap = 0x1p-9;
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
/// [energies] Rise that rounding explains.
constexpr double k_rounding = 0x1p-46;
/// Bisections of a way that leads into an overlap.
constexpr int k_way_halvings = 10;
/// Rounds of taking off overlap: each leaves about the square of what the last has found.
constexpr int k_rounds = 4;
// [rest.overlap.limits]

} // namespace

// [rest.overlap.may]
bool RestEngine::may_overlap(const ContactPoint& c) const
{
    // A gap along a fixed normal is never more than the distance; turning may change what lies furthest along it
    if (c.left != span_) return true;
    const double way = c.n_x * (shift_[c.b].x() - shift_[c.a].x()) + c.n_y * (shift_[c.b].y() - shift_[c.a].y());
    const double turn = c.normal_arm_b * turn_[c.b] - c.normal_arm_a * turn_[c.a];
    const double doubt = std::abs(turn_[c.a]) * turning_[c.a] + std::abs(turn_[c.b]) * turning_[c.b];
    return c.gap + way + turn - doubt < -touch_gap(c.a, c.b);
}
// [rest.overlap.may]

// [rest.overlap.look]
double RestEngine::look_at_end(const Group& group)
{
    place_points_.clear();
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.all_points);
    if (std::none_of(points.begin(), points.end(), [&](const ContactPoint& c) { return may_overlap(c); })) return 0.0;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        const BodyState& s = bodies_[member].state;
        next_poses_[member] = {s.position + shift_[member], Rotation::of(s.angle + turn_[member])};
    }
    double worst = 0.0;
    int last = -1;
    for (const ContactPoint& from : points) {
        if (from.pair == last) continue;
        last = from.pair;
        const RestPair& pair = pairs_.pairs()[from.pair];
        const double size = std::min(radius_[pair.a], radius_[pair.b]);
        const Manifold manifold =
            look(pair, next_poses_[pair.a], next_poses_[pair.b], rest_tolerance::k_watch * size);
        ++counts_.manifolds;
        for (int k = 0; k < manifold.count; ++k) {
            const Contact& contact = manifold.contacts[k];
            ContactPoint& c = place_points_.emplace_back();
            c.a = pair.a;
            c.b = pair.b;
            c.pair = from.pair;
            c.feature = contact.feature;
            set_arms(c, contact.normal, contact.point - next_poses_[pair.a].position,
                     contact.point - next_poses_[pair.b].position);
            c.bound = -contact.separation;
            const double depth = -contact.separation - touch_gap(pair.a, pair.b);
            worst = std::max(worst, depth / size);
        }
    }
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

// [rest.overlap.short]
void RestEngine::cut_ways_short(const Group& group, double overlap)
{
    // Where nothing has brought a group to where it overlaps no more than before, whoever does goes as far only as they
    // don't; and who then overlaps with them
    const double most = std::max(k_fair_overlap, overlap_at_start(group));
    if (overlap <= most) return;
    ++counts_.held;
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    for (const int member : members) {
        shift_before_[member] = shift_[member];
        turn_before_[member] = turn_[member];
        held_[member] = 0;
    }
    const auto go = [&](double share) {
        for (const int member : members) {
            if (!held_[member]) continue;
            shift_[member] = share * shift_before_[member];
            turn_[member] = share * turn_before_[member];
        }
        return look_at_end(group);
    };
    for (bool any = true; any && overlap > most;) {
        any = false;
        for (const ContactPoint& c : place_points_) {
            if (c.bound - touch_gap(c.a, c.b) <= most * std::min(radius_[c.a], radius_[c.b])) continue;
            for (const int body : {c.a, c.b}) {
                any = any || (!bodies_[body].is_static && !held_[body]);
                held_[body] = 1;
            }
        }
        overlap = go(0.0);
    }
    double low = 0.0;
    double high = 1.0;
    for (int k = 0; k < k_way_halvings; ++k) {
        const double middle = 0.5 * (low + high);
        (go(middle) <= most ? low : high) = middle;
    }
    go(low);
}
// [rest.overlap.short]

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
        const double field = span_ * bodies_[member].acceleration.cwiseAbs().sum();
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
    return is_sane(group) && overlap <= std::max(k_fair_overlap, overlap_at_start(group));
}

double RestEngine::first_impact(const Group& group) const
{
    // Where one contact is struck while others bear, the others bear something else before and after
    double first = span_;
    bool all_at_once = true;
    double common = -1.0;
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
    const Gain gain = gain_of(group);
    return gain.gained <= k_fair_rise * gain.scale;
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
        const double work = bodies_[member].acceleration.dot(shift_[member]) / now.inv_mass;
        gain.gained += (after - before) - work;
        const Vec2& field = bodies_[member].acceleration;
        const double through_field = field.cwiseProduct(shift_[member]).cwiseAbs().sum();
        const double in_a_step = (span_ * field).squaredNorm(); // the solve's rounding is in proportion to it
        gain.scale += after + before + (through_field + in_a_step) / now.inv_mass;
    }
    return gain;
}
// [rest.energy.gain]

// [rest.energy.pay]
void RestEngine::pay_for_rise(const Group& group)
{
    const Gain gain = gain_of(group);
    if (gain.gained <= k_rounding * gain.scale) return;
    ++counts_.paid;

    // A group that leans on what is static slows down as it is; others about their centre of mass
    bool leans = false;
    for (int k = 0; k < group.point_count; ++k) {
        const ContactPoint& c = points_[group.first_point + k];
        leans = leans || (c.normal > 0.0 && (bodies_[c.a].is_static || bodies_[c.b].is_static));
    }
    double mass = 0.0;
    Vec2 momentum = Vec2::Zero();
    for (int k = 0; k < group.member_count && !leans; ++k) {
        const Mover& now = movers_[members_[group.first_member + k]];
        mass += 1.0 / now.inv_mass;
        momentum += Vec2(now.v_x, now.v_y) / now.inv_mass;
    }
    const Vec2 common = leans ? Vec2(Vec2::Zero()) : Vec2(momentum / mass);
    double energy = 0.0;
    for (int k = 0; k < group.member_count; ++k) {
        const Mover& now = movers_[members_[group.first_member + k]];
        const Vec2 own = Vec2(now.v_x, now.v_y) - common;
        energy += 0.5 * (own.squaredNorm() / now.inv_mass + now.spin * now.spin / now.inv_moment);
    }
    const double share = energy > gain.gained ? std::sqrt(1.0 - gain.gained / energy) : 0.0;
    double lift = 0.0;
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        Mover& now = movers_[member];
        now.v_x = common.x() + share * (now.v_x - common.x());
        now.v_y = common.y() + share * (now.v_y - common.y());
        now.spin *= share;
        lift -= bodies_[member].acceleration.dot(shift_[member]) / now.inv_mass;
    }
    if (share > 0.0) return;

    // Who has nothing left to pay with rises no further than the motion before would have carried it
    const double part = std::max(0.0, 1.0 - (gain.gained - energy) / lift);
    for (int k = 0; k < group.member_count; ++k) {
        const int member = members_[group.first_member + k];
        shift_[member] *= part;
        turn_[member] *= part;
    }
}
// [rest.energy.pay]

} // namespace flying
