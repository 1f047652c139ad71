#include <algorithm>
#include <cmath>
#include <limits>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {


/// Points of the largest group whose lines of push are followed along its ways.
constexpr int k_most_followed = 16;
/// [1, or sizes] A line of push that changes by less within a step is straight.
constexpr double k_straight = 0x1p-36;
/// [speeds that the field gives in a step] Slip beyond this is a slide.
constexpr double k_slide = 0x1p-10;
/// Rounds, each with lines along the ways that the last has found; and the part of what counts as touching that they
/// may leave of a gap.
constexpr int k_most_rounds = 6;
constexpr double k_left_of_gap = 0.125;



/// Lines as the mean of three: at the start of a way, halfway, and at its end.
void set_mean_lines(ContactPoint& mean, const ContactPoint& start, const ContactPoint& half, const ContactPoint& end,
                    const Mover& a, const Mover& b)
{

    // The mean of a line over a way, by the rule for barrels
    const auto simpson = [&](double ContactPoint::* number) {
        return ((start.*number + end.*number) + 4.0 * half.*number) / 6.0;
    };

    mean.n_x = simpson(&ContactPoint::n_x);
    mean.n_y = simpson(&ContactPoint::n_y);
    mean.normal_arm_a = simpson(&ContactPoint::normal_arm_a);
    mean.normal_arm_b = simpson(&ContactPoint::normal_arm_b);
    mean.tangent_arm_a = simpson(&ContactPoint::tangent_arm_a);
    mean.tangent_arm_b = simpson(&ContactPoint::tangent_arm_b);
    const double shift = (a.inv_mass + b.inv_mass) * (mean.n_x * mean.n_x + mean.n_y * mean.n_y);
    const auto mass = [&](double arm_a, double arm_b) {
        return 1.0 / (shift + (a.inv_moment * (arm_a * arm_a) + b.inv_moment * (arm_b * arm_b)));
    };
    mean.normal_mass = mass(mean.normal_arm_a, mean.normal_arm_b);
    mean.tangent_mass = mass(mean.tangent_arm_a, mean.tangent_arm_b);
}

/// How far two points' lines are from each other; arms in units of `size`.
[[nodiscard]] double bend_of(const ContactPoint& one, const ContactPoint& two, const Mover& a, const Mover& b, double size)
{
    const double normal = std::abs(one.n_x - two.n_x) + std::abs(one.n_y - two.n_y);
    double of_a = std::abs(one.normal_arm_a - two.normal_arm_a) + std::abs(one.tangent_arm_a - two.tangent_arm_a);
    double of_b = std::abs(one.normal_arm_b - two.normal_arm_b) + std::abs(one.tangent_arm_b - two.tangent_arm_b);
    if (a.inv_moment == 0.0) of_a = 0.0; // what never turns has no arms
    if (b.inv_moment == 0.0) of_b = 0.0;
    return normal + std::max(of_a, of_b) / size;
}

/// The gap with which a point that bears is to end the step: none, where it is near to not counting as touching; else
/// that with which it began, since to lift a body by a rounding costs all of a small motion.  [m]
[[nodiscard]] double least_gap(const ContactPoint& c, double touch)
{
    return c.gap > 0.5 * touch ? 0.0 : c.gap;
}


} // namespace


bool RestEngine::follow_curves(Group& group)
{
    const std::span<ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    if (!may_bend(group)) return false;
    curves_.bent.assign(points.begin(), points.end());
    first_ways(group);
    if (bend_lines(group, false) != Bend::some) {
        forget_ways(group);
        return false;
    }

    // Find ways, and the lines along them, until both fit
    curves_.straight.resize(movers_.size());
    for (const int member : members) curves_.straight[member] = movers_[member];
    bool content = true;
    for (int round = 1; content; ++round) {
        content = find_mean_velocities(group) && see_ends(group);
        if (round == k_most_rounds || (content && all_close())) break;
        content = content && bend_lines(group, true) != Bend::lost;
    }
    content = content && end_velocities(group);
    if (!content) {
        for (const int member : members) movers_[member] = curves_.straight[member];
        forget_ways(group);
        return false;
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        points[k].normal = curves_.bent[k].normal;
        points[k].tangent = curves_.bent[k].tangent;
    }
    group.has_ways = true;
    return true;
}



bool RestEngine::may_bend(const Group& group) const
{
    // A few that move, some of which bear
    if (group.point_count > k_most_followed || strikes_at_start(group) || !group.is_content) return false;
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    if (std::none_of(points.begin(), points.end(), [](const ContactPoint& c) { return c.normal > 0.0; })) return false;

    // A slide that ends is parted where it does; below, slip is what the last step's end has left
    if (any_slip_ended(group, k_slide * field_speed(group))) return false;
    return top_motion(group) > still_speed(group);
}

double RestEngine::top_motion(const Group& group) const
{
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    return std::max(greatest_speed(before_, radius_, members), greatest_speed(movers_, radius_, members));
}

void RestEngine::first_ways(const Group& group)
{
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        const Mover& old = before_[member];
        const Mover& now = movers_[member];
        shift_[member] = 0.5 * span_ * Vec2(old.v_x + now.v_x, old.v_y + now.v_y);
        turn_[member] = 0.5 * span_ * (old.spin + now.spin);
    }
}

void RestEngine::forget_ways(const Group& group)
{
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        shift_[member] = Vec2::Zero();
        turn_[member] = 0.0;
    }
}



/// The contact that continues a point further along the ways: the one of its name, or, where names have changed, the one
/// nearest to its place; null where there is none.
const Contact* RestEngine::same_contact(const ContactPoint& c, const Manifold& manifold) const
{
    const RestPair& pair = pairs_.pairs()[c.pair];
    const auto own = std::find(pair.feature, pair.feature + pair.count, c.feature);
    if (own == pair.feature + pair.count) return nullptr;
    const Vec2 place = pair.place[own - pair.feature];
    const int body = bodies_[c.a].is_static ? c.b : c.a;
    const double near = rest_tolerance::k_same_place * std::min(radius_[c.a], radius_[c.b]);
    const Contact* best = nullptr;
    double least = near * near;
    for (int i = 0; i < manifold.count; ++i) {
        const Contact& contact = manifold.contacts[i];
        if (contact.feature == c.feature) return &contact;
        const Pose& pose = next_poses_[body];
        const Vec2 there = inverse(pose.rotation) * Vec2(contact.point - pose.position);
        const double square = (there - place).squaredNorm();
        if (square < least) { best = &contact; least = square; }
    }
    return best;
}

/// Where the points are at a part of the ways; those not seen there are not followed.
void RestEngine::look_along(const Group& group, double part, std::vector<ContactPoint>& there)
{
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    for (const int member : std::span(members_).subspan(group.first_member, group.member_count)) {
        const BodyState& s = bodies_[member].state;
        next_poses_[member] = {s.position + part * shift_[member], Rotation::of(s.angle + part * turn_[member])};
    }
    Manifold manifold;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        if (k == 0 || c.pair != points[k - 1].pair) {
            const double margin = rest_tolerance::k_watch * std::min(radius_[c.a], radius_[c.b]);
            manifold = look(pairs_.pairs()[c.pair], next_poses_[c.a], next_poses_[c.b], margin);
            ++counts_.manifolds;
        }
        const Contact* found = same_contact(c, manifold);
        if (!found) {
            curves_.is_seen[k] = 0;
            continue;
        }
        there[k].gap = found->separation;
        set_arms(there[k], found->normal, found->point - next_poses_[c.a].position,
                 found->point - next_poses_[c.b].position);
    }
}



RestEngine::Bend RestEngine::bend_lines(const Group& group, bool is_corrected)
{
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    curves_.half.assign(points.begin(), points.end());
    curves_.end.assign(points.begin(), points.end());
    curves_.is_seen.assign(points.size(), 1);
    look_along(group, 0.5, curves_.half);
    look_along(group, 1.0, curves_.end);

    // The mean over the way is what changes the gap; a bend that changes velocities by less than the solve's rounding is
    // none
    const double motion = top_motion(group);
    const double rounding = rest_tolerance::k_content * top_speed(group);
    bool any = false;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        ContactPoint& bent = curves_.bent[k];
        if (!curves_.is_seen[k]) {
            // Whoever bears must be seen; another that has gone out of sight no longer matters
            if (c.normal > 0.0) return Bend::lost;
            bent.bound = -std::numeric_limits<double>::infinity();
            continue;
        }
        set_mean_lines(bent, c, curves_.half[k], curves_.end[k], movers_[c.a], movers_[c.b]);
        const double size = std::min(radius_[c.a], radius_[c.b]);
        const double bend = bend_of(c, curves_.end[k], movers_[c.a], movers_[c.b], size);
        any = any || (c.normal > 0.0 && bend > k_straight && bend * motion > rounding);

        // Ways that lead to a gap or an overlap are to end without it
        const double touch = touch_gap(c.a, c.b);
        bent.bound = std::isinf(c.bound) ? c.bound : c.gap > touch ? -c.gap / span_ : 0.0;
        const double left = curves_.end[k].gap - least_gap(c, touch);
        if (!is_corrected || std::isinf(c.bound) || std::abs(left) <= k_left_of_gap * touch) continue;
        const auto along_ways = [&](int body) {
            return Mover{shift_[body].x(), shift_[body].y(), turn_[body], 0.0, 0.0};
        };
        bent.bound = (normal_speed(bent, along_ways(c.a), along_ways(c.b)) - left) / span_;
    }
    return any ? Bend::some : Bend::none;
}



bool RestEngine::find_mean_velocities(const Group& group)
{
    const std::span<const ContactPoint> points = std::span(points_).subspan(group.first_point, group.point_count);
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    for (std::size_t k = 0; k < points.size(); ++k) {
        ContactPoint& c = curves_.bent[k];
        c.normal = 0.5 * points[k].normal;
        c.tangent = 0.5 * points[k].tangent;
    }
    // [rest.curves.half]
    // Half of the field and half of the impulses lead to the mean of the velocities
    for (const int member : members) {
        const Vec2 gain = 0.5 * span_ * field_[member];
        const Mover& old = before_[member];
        Mover& mean = movers_[member];
        mean = old;
        mean.v_x += gain.x();
        mean.v_y += gain.y();
    }
    const double rounding = rest_tolerance::k_content * top_speed(group);
    const bool content = solver_.solve(movers_, members, curves_.bent, rounding);
    // [rest.curves.half]
    for (const int member : members) {
        const Mover& mean = movers_[member];
        shift_[member] = span_ * Vec2(mean.v_x, mean.v_y);
        turn_[member] = span_ * mean.spin;
    }
    return content;
}

bool RestEngine::see_ends(const Group& group)
{
    look_along(group, 1.0, curves_.end);
    for (std::size_t k = 0; k < curves_.bent.size(); ++k) {
        if (!curves_.is_seen[k] && curves_.bent[k].normal > 0.0) return false;
    }
    return true;
}

bool RestEngine::all_close() const
{
    for (std::size_t k = 0; k < curves_.bent.size(); ++k) {
        const ContactPoint& c = curves_.bent[k];
        if (!(c.normal > 0.0)) continue;
        const double touch = touch_gap(c.a, c.b);
        const double left = curves_.end[k].gap - least_gap(c, touch);
        if (std::abs(left) > k_left_of_gap * touch) return false;
    }
    return true;
}



bool RestEngine::end_velocities(const Group& group)
{
    // As far beyond the mean as the start was before it
    const std::span<const int> members = std::span(members_).subspan(group.first_member, group.member_count);
    for (const int member : members) {
        const Mover& old = before_[member];
        Mover& now = movers_[member];
        now.v_x = 2.0 * now.v_x - old.v_x;
        now.v_y = 2.0 * now.v_y - old.v_y;
        now.spin = 2.0 * now.spin - old.spin;
    }

    // What bears leaves the step along the surfaces as they lie at its end
    const auto lasts = [](const ContactPoint& c) { return c.normal > 0.0; };
    load_points_.clear();
    for (std::size_t k = 0; k < curves_.bent.size(); ++k) {
        ContactPoint& c = curves_.bent[k];
        c.normal *= 2.0;
        c.tangent *= 2.0;
        if (!lasts(c)) continue;
        ContactPoint& end = load_points_.emplace_back(curves_.end[k]);
        end.bound = 0.0;
        end.normal = c.normal;
        end.tangent = c.tangent;
        push(end, -c.normal, -c.tangent, movers_[c.a], movers_[c.b]);
    }
    if (load_points_.empty()) return true;
    const bool content = solver_.solve(movers_, members, load_points_, rest_tolerance::k_content * top_speed(group));
    auto end = load_points_.begin();
    for (std::size_t k = 0; k < curves_.bent.size(); ++k) {
        ContactPoint& c = curves_.bent[k];
        if (!lasts(c)) continue;
        c.normal = end->normal;
        c.tangent = end->tangent;
        ++end;
    }
    return content;
}


} // namespace flying
