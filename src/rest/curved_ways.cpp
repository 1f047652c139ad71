#include "rest/curved_ways.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "rest/energy_limit.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/step_field.hpp"

namespace flying {
namespace {

/// Lines as the mean of three: at the start of a way, halfway, and at its end.
void set_mean_lines(ContactPoint& mean, const ContactPoint& start, const ContactPoint& half, const ContactPoint& end,
                    const Mover& a, const Mover& b)
{
    // [rest.curves.simpson]
    // The mean of a line over a way, by Simpson's rule
    const auto simpson = [&](double ContactPoint::*number) {
        return ((start.*number + end.*number) + 4.0 * half.*number) / 6.0;
    };
    // [rest.curves.simpson]
    mean.n_x = simpson(&ContactPoint::n_x);
    mean.n_y = simpson(&ContactPoint::n_y);
    mean.normal_arm_a = simpson(&ContactPoint::normal_arm_a);
    mean.normal_arm_b = simpson(&ContactPoint::normal_arm_b);
    mean.tangent_arm_a = simpson(&ContactPoint::tangent_arm_a);
    mean.tangent_arm_b = simpson(&ContactPoint::tangent_arm_b);
    const double shifts = (a.inv_mass + b.inv_mass) * (mean.n_x * mean.n_x + mean.n_y * mean.n_y);
    mean.normal_mass = effective_mass(shifts, a, b, mean.normal_arm_a, mean.normal_arm_b);
    mean.tangent_mass = effective_mass(shifts, a, b, mean.tangent_arm_a, mean.tangent_arm_b);
}

/// How far two points' lines are from each other; arms in units of `size`.
[[nodiscard]] double bend_of(const ContactPoint& one, const ContactPoint& two, const Mover& a, const Mover& b,
                             double size)
{
    const double normal = std::abs(one.n_x - two.n_x) + std::abs(one.n_y - two.n_y);
    double of_a = std::abs(one.normal_arm_a - two.normal_arm_a) + std::abs(one.tangent_arm_a - two.tangent_arm_a);
    double of_b = std::abs(one.normal_arm_b - two.normal_arm_b) + std::abs(one.tangent_arm_b - two.tangent_arm_b);
    if (a.inv_moment == 0.0) of_a = 0.0; // what never turns has no arms
    if (b.inv_moment == 0.0) of_b = 0.0;
    return normal + std::max(of_a, of_b) / size;
}

/// By how much it changes velocities at a point, at most, that its line is another.  [m/s]
[[nodiscard]] double change_by(const ContactPoint& one, const ContactPoint& two, const Mover& a, const Mover& b)
{
    const double normal = std::abs(one.n_x - two.n_x) + std::abs(one.n_y - two.n_y);
    const double of_a = std::abs(one.normal_arm_a - two.normal_arm_a) + std::abs(one.tangent_arm_a - two.tangent_arm_a);
    const double of_b = std::abs(one.normal_arm_b - two.normal_arm_b) + std::abs(one.tangent_arm_b - two.tangent_arm_b);
    const double speed = std::abs(b.v_x - a.v_x) + std::abs(b.v_y - a.v_y);
    return normal * speed + of_a * std::abs(a.spin) + of_b * std::abs(b.spin);
}

/// The gap with which a point that bears is to end the step: none, where it is near to not counting as touching; else
/// that with which it began, since to lift a body by a rounding costs all of a small motion.  [m]
[[nodiscard]] double least_gap(const ContactPoint& c, double touch)
{
    return c.gap > 0.5 * touch ? 0.0 : c.gap;
}

/// The greatest velocity with which the step begins or ends.  [m/s]
[[nodiscard]] double top_motion(const RestData& data, const Island& island)
{
    const std::vector<double>& radius = data.bodies.radius;
    return std::max(greatest_speed(data.motion.before, radius, island.members),
                    greatest_speed(data.motion.now, radius, island.members));
}

/// Points between bodies of which one moves, with some velocities: the lines of others stay as they are.
[[nodiscard]] int points_that_move(const RestData& data, const Island& island, std::span<const Mover> movers)
{
    const double still = rest_tolerance::k_still * field_speed(data, island);
    const auto moves = [&](int body) { return greatest_speed(movers, data.bodies.radius, {&body, 1}) > still; };
    return static_cast<int>(std::count_if(island.points.begin(), island.points.end(),
                                          [&](const ContactPoint& c) { return moves(c.a) || moves(c.b); }));
}

[[nodiscard]] bool may_bend(const RestData& data, const Island& island)
{
    if (!island.is_solved) return false;
    const std::span<const ContactPoint> points = island.points;

    // Where nothing may be lost, a contact that hops leaves as it came, and not along the surfaces
    const auto hops = [](const ContactPoint& c) { return c.normal > 0.0 && c.bound != 0.0; };
    if (is_lossless(island) && std::any_of(points.begin(), points.end(), hops)) return false;
    if (top_motion(data, island) <= still_speed(data, island)) return false;
    return is_loose(data, island) ||
           points_that_move(data, island, data.motion.now) <= rest_tolerance::k_most_in_detail;
}

void forget_ways(RestData& data, const Island& island)
{
    for (const int member : island.members) {
        data.motion.shift[member] = Vec2::Zero();
        data.motion.turn[member] = 0.0;
    }
}

void take_first_ways(RestData& data, const Island& island)
{
    forget_ways(data, island);
    StepMotion& motion = data.motion;
    for (const int member : island.members)
        motion.add_mean_way(member, motion.before[member], motion.now[member], motion.span);
}

/// The contact that continues a point further along the ways, in a look at its pair or at one beside it: the one of its
/// name, or, where names have changed, the one nearest to its place.
[[nodiscard]] std::optional<Contact> same_contact(const RestData& data, const ContactPoint& c, const Manifold& manifold,
                                                  bool is_beside)
{
    const RestPair& pair = data.pairs.pairs()[c.pair];
    const Vec2& place = pair.place[c.own];
    const int body = data.bodies.list[c.a].is_static ? c.b : c.a;
    const double near = rest_tolerance::k_watch * data.bodies.size_of(c.a, c.b);
    std::optional<Contact> best;
    double least = near * near;
    for (int i = 0; i < manifold.count; ++i) {
        const Contact& contact = manifold.contacts[i];
        if (contact.feature == pair.feature[c.own] && !is_beside) return contact;
        const Pose& pose = data.motion.end_poses[body];
        const Vec2 there = inverse(pose.rotation) * Vec2(contact.point - pose.position);
        const double square = (there - place).squaredNorm();
        if (square < least) {
            best = contact;
            least = square;
        }
    }
    return best;
}

/// The same where a point that bears has passed a seam of a floor that never moves: the next tile bears it on.
[[nodiscard]] std::optional<Contact> same_contact_beside(const RestData& data, const ContactPoint& c, double margin)
{
    std::optional<Contact> found;
    const bool is_second = data.bodies.list[c.a].is_static;
    const int body = is_second ? c.b : c.a;
    if (!(is_second || data.bodies.list[c.b].is_static)) return found;
    data.pairs.for_each_of(body, [&](std::span<const RestPair> pairs) {
        for (const RestPair& pair : pairs) {
            const bool is_own = pair.a == c.a && pair.b == c.b;
            if (found || is_own || !data.bodies.list[pair.a == body ? pair.b : pair.a].is_static) return;
            const Manifold manifold =
                look(data, pair, data.motion.end_poses[pair.a], data.motion.end_poses[pair.b], margin);
            found = same_contact(data, c, manifold, true);
            if (found && is_second != (pair.b == body)) found->normal = -found->normal;
        }
    });
    return found;
}

} // namespace

bool CurvedWays::may_follow(const RestData& data, const Island& island)
{
    return stood(data, island) || is_loose(data, island) ||
           points_that_move(data, island, data.motion.before) <= rest_tolerance::k_most_in_detail;
}

bool CurvedWays::follow(RestData& data, Island& island)
{
    const std::span<ContactPoint> points = island.points;
    const std::span<const int> members = island.members;
    lets_go_ = false;
    if (!may_bend(data, island)) return false;
    bent_.assign(points.begin(), points.end());
    take_first_ways(data, island);
    if (bend_lines(data, island, false) != Bend::some) {
        forget_ways(data, island);
        return false;
    }

    // Find ways, and the lines along them, until both fit
    straight_.resize(data.motion.now.size());
    for (const int member : members) straight_[member] = data.motion.now[member];
    bool content = true;
    for (int round = 1; content; ++round) {
        content = find_mean_velocities(data, island) && see_ends(data, island);
        if (round == rest_tolerance::k_quick_rounds || (content && all_close(data))) break;
        content = content && bend_lines(data, island, true) != Bend::lost;
    }
    content = content && end_velocities(data, island);
    if (!content) {
        for (const int member : members) data.motion.now[member] = straight_[member];
        forget_ways(data, island);
        return false;
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        points[k].normal = bent_[k].normal;
        points[k].tangent = bent_[k].tangent;
    }
    island.has_ways = true;
    return true;
}

double CurvedWays::end_of_slip(const RestData& data, const Island& island) const
{
    const double field = field_speed(data, island) * (data.options.step / data.motion.span);
    const double slide = rest_tolerance::k_blow * field;
    const double still = rest_tolerance::k_still * field;
    double first = data.motion.span;
    for (std::size_t k = 0; k < bent_.size() && slide > 0.0; ++k) {
        const ContactPoint& c = bent_[k];
        if (!(c.normal > 0.0) || c.friction == 0.0) continue;
        const ContactPoint& start = island.points[k];
        const double slip = tangent_speed(start, data.motion.before[c.a], data.motion.before[c.b]);
        const double after = tangent_speed(end_[k], data.motion.now[c.a], data.motion.now[c.b]);
        const bool goes_on = slip > 0.0 ? after > still : after < -still;
        if (!(std::abs(slip) > slide) || goes_on) continue;

        // Find the slip to which the friction of a slide would have led, with the same normal velocity
        const Mover& a = data.motion.now[c.a];
        const Mover& b = data.motion.now[c.b];
        const double both = c.normal_mass * (a.inv_moment * (c.normal_arm_a * c.tangent_arm_a) +
                                             b.inv_moment * (c.normal_arm_b * c.tangent_arm_b));
        const double share = slip > 0.0 ? -c.friction : c.friction;
        const double more = (share * c.normal - c.tangent) / (1.0 + share * both);
        const double slid = after + more * (1.0 / c.tangent_mass - both * both / c.normal_mass);
        // Where friction wedges the point, that says nothing, and halves do
        const double part = slip * slid < 0.0 ? slip / (slip - slid) : 0.5;
        first = std::min(first, part * data.motion.span);
    }
    return first < (1.0 - rest_tolerance::k_blow) * data.motion.span ? first : 0.0;
}

void CurvedWays::take_lines_halfway(RestData& data, Island& island)
{
    for (const int member : island.members) {
        const Mover& old = data.motion.before[member];
        data.motion.shift[member] = data.motion.span * Vec2(old.v_x, old.v_y);
        data.motion.turn[member] = data.motion.span * old.spin;
    }
    half_.assign(island.points.begin(), island.points.end());
    is_seen_.assign(half_.size(), 1);
    look_along(data, island, 0.5, half_);
    for (std::size_t k = 0; k < half_.size(); ++k) {
        ContactPoint& c = island.points[k];
        if (c.normal == 0.0) continue;
        half_[k].gap = c.gap;
        c = half_[k];
    }
    forget_ways(data, island);
}

/// Where the points are at a part of the ways; those not seen there are not followed.
void CurvedWays::look_along(RestData& data, const Island& island, double part, std::vector<ContactPoint>& there)
{
    const std::span<const ContactPoint> points = island.points;
    set_end_poses(data, island, part);
    Manifold manifold;
    double margin = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        const double size = data.bodies.size_of(c.a, c.b);
        // The line between two that stay where they are stays, too
        if (farthest_way(data, c.a) + farthest_way(data, c.b) <= rest_tolerance::k_straight * size) continue;
        if (k == 0 || c.pair != points[k - 1].pair) {
            margin = data.motion.reach[c.a] + data.motion.reach[c.b] + rest_tolerance::k_watch * size;
            manifold =
                look(data, data.pairs.pairs()[c.pair], data.motion.end_poses[c.a], data.motion.end_poses[c.b], margin);
            ++data.counts.manifolds;
        }
        std::optional<Contact> found = same_contact(data, c, manifold, false);
        if (!found && c.normal > 0.0) found = same_contact_beside(data, c, margin);
        if (!found) {
            is_seen_[k] = 0;
            continue;
        }
        there[k].gap = found->separation;
        data.motion.set_arms(there[k], found->normal, found->point - data.motion.end_poses[c.a].position,
                             found->point - data.motion.end_poses[c.b].position);
    }
}

CurvedWays::Bend CurvedWays::bend_lines(RestData& data, const Island& island, bool is_corrected)
{
    const std::span<const ContactPoint> points = island.points;
    half_.assign(points.begin(), points.end());
    end_.assign(points.begin(), points.end());
    is_seen_.assign(points.size(), 1);
    look_along(data, island, 0.5, half_);
    look_along(data, island, 1.0, end_);

    // The mean over the way is what changes the gap; a bend that changes velocities by less than the solve's rounding
    // is none
    const double motion = top_motion(data, island);
    const double rounding = rest_tolerance::k_residual * top_speed(data, island);
    // What slides over a heap without turning goes straight, though it is pushed elsewhere as it goes
    const double still = still_speed(data, island);
    const auto turns = [&](const ContactPoint& c, const ContactPoint& end) {
        return !is_heap(island) || change_by(c, end, data.motion.now[c.a], data.motion.now[c.b]) > still;
    };
    // What touches may come to bear where its line bends, though nothing presses on it: a way that was followed leaves
    // half as much again as counts as touching. What hops without any loss hops on
    const auto may_bear = [&](const ContactPoint& c) {
        return c.normal > 0.0 || (!is_lossless(c) && c.gap <= 2.0 * data.bodies.touch_gap(c.a, c.b));
    };
    bool any = false;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const ContactPoint& c = points[k];
        ContactPoint& bent = bent_[k];
        if (!is_seen_[k]) {
            // What bears must be seen; another point that has gone out of sight no longer matters
            if (c.normal > 0.0) return Bend::lost;
            bent.bound = -std::numeric_limits<double>::infinity();
            continue;
        }
        set_mean_lines(bent, c, half_[k], end_[k], data.motion.now[c.a], data.motion.now[c.b]);
        const double size = data.bodies.size_of(c.a, c.b);
        const double bend = bend_of(c, end_[k], data.motion.now[c.a], data.motion.now[c.b], size);
        any =
            any || (may_bear(c) && bend > rest_tolerance::k_straight && bend * motion > rounding && turns(c, end_[k]));

        // Ways that lead to a gap or an overlap are to end without it
        const double touch = data.bodies.touch_gap(c.a, c.b);
        bent.bound = std::isinf(c.bound) ? c.bound : c.gap > touch ? -c.gap / data.motion.span : 0.0;
        const double left = end_[k].gap - least_gap(c, touch);
        if (!is_corrected || std::isinf(c.bound) || std::abs(left) <= touch) continue;
        const auto along_ways = [&](int body) {
            return Mover{data.motion.shift[body].x(), data.motion.shift[body].y(), data.motion.turn[body], 0.0, 0.0};
        };
        bent.bound = (normal_speed(bent, along_ways(c.a), along_ways(c.b)) - left) / data.motion.span;
    }
    return any ? Bend::some : Bend::none;
}

bool CurvedWays::find_mean_velocities(RestData& data, const Island& island)
{
    const std::span<const ContactPoint> points = island.points;
    const std::span<const int> members = island.members;
    for (std::size_t k = 0; k < points.size(); ++k) {
        ContactPoint& c = bent_[k];
        c.normal = 0.5 * points[k].normal;
        c.tangent = 0.5 * points[k].tangent;
    }
    // [rest.curves.half]
    // Half of the field and half of the impulses lead to the mean of the velocities
    for (const int member : members) {
        const Vec2 gain = 0.5 * data.motion.span * data.motion.field[member];
        const Mover& old = data.motion.before[member];
        Mover& mean = data.motion.now[member];
        mean = old;
        mean.v_x += gain.x();
        mean.v_y += gain.y();
    }
    const double rounding = rest_tolerance::k_residual * top_speed(data, island);
    const bool content = data.solver.solve(data.motion.now, members, bent_, rounding);
    // [rest.curves.half]
    for (const int member : members) {
        const Mover& mean = data.motion.now[member];
        data.motion.shift[member] = data.motion.span * Vec2(mean.v_x, mean.v_y);
        data.motion.turn[member] = data.motion.span * mean.spin;
    }
    return content;
}

bool CurvedWays::see_ends(RestData& data, const Island& island)
{
    look_along(data, island, 1.0, end_);
    for (std::size_t k = 0; k < bent_.size(); ++k) {
        if (!is_seen_[k] && bent_[k].normal > 0.0) return false;
    }
    return true;
}

bool CurvedWays::all_close(const RestData& data) const
{
    for (std::size_t k = 0; k < bent_.size(); ++k) {
        const ContactPoint& c = bent_[k];
        if (!(c.normal > 0.0)) continue;
        const double touch = data.bodies.touch_gap(c.a, c.b);
        const double left = end_[k].gap - least_gap(c, touch);
        if (std::abs(left) > touch) return false;
    }
    return true;
}

bool CurvedWays::end_velocities(RestData& data, Island& island)
{
    // As far beyond the mean as the start was before it
    const std::span<const int> members = island.members;
    for (const int member : members) {
        const Mover& old = data.motion.before[member];
        Mover& now = data.motion.now[member];
        now.v_x = 2.0 * now.v_x - old.v_x;
        now.v_y = 2.0 * now.v_y - old.v_y;
        now.spin = 2.0 * now.spin - old.spin;
    }

    // What bears leaves the step along the surfaces as they lie at its end
    const auto lasts = [](const ContactPoint& c) { return c.normal > 0.0; };
    at_end_.clear();
    for (std::size_t k = 0; k < bent_.size(); ++k) {
        ContactPoint& c = bent_[k];
        c.normal *= 2.0;
        c.tangent *= 2.0;
        if (!lasts(c)) continue;
        ContactPoint& end = at_end_.emplace_back(end_[k]);
        end.bound = 0.0;
        end.normal = c.normal;
        end.tangent = c.tangent;
        push(end, -c.normal, -c.tangent, data.motion.now[c.a], data.motion.now[c.b]);
    }
    if (at_end_.empty()) {
        fly(data, island);
        return true;
    }
    const bool content =
        data.solver.solve(data.motion.now, members, at_end_, rest_tolerance::k_residual * top_speed(data, island));
    // Of several points that bear one load, some may have none at the end, and stay where they are
    const double still = still_speed(data, island);
    lets_go_ = std::any_of(at_end_.begin(), at_end_.end(), [&](const ContactPoint& c) {
        return !lasts(c) && normal_speed(c, data.motion.now[c.a], data.motion.now[c.b]) > still;
    });
    // Such a step is made in halves. Where it can't be, as in a heap, the point ends the step open
    if (lets_go_ && island.in_turn) return false;
    auto end = at_end_.begin();
    for (std::size_t k = 0; k < bent_.size(); ++k) {
        ContactPoint& c = bent_[k];
        if (!lasts(c)) continue;
        c.normal = end->normal;
        c.tangent = end->tangent;
        ++end;
    }
    return content;
}

} // namespace flying
