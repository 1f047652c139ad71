#include "rest/rest_engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/hash.hpp"
#include "rest/rest_tolerance.hpp"
#include "rest/stopwatch.hpp"

namespace flying {
namespace {

[[nodiscard]] Mover mover_of(const RestBody& body)
{
    if (body.is_static) return {};
    const BodyState& s = body.state;
    return {s.velocity.x(), s.velocity.y(), s.spin, body.inertia.inv_mass, body.inertia.inv_moment_of_inertia};
}

/// Which edges of the convex parts are sides of the shape, and not cuts through it.
[[nodiscard]] std::vector<char> real_edges(const Shape& shape, const CollisionShape& parts)
{
    std::vector<char> result;
    const auto* whole = std::get_if<Polygon>(&shape);
    if (!whole || parts.parts.size() == 1) return result;
    const auto is_side = [&](const Vec2& from, const Vec2& to) {
        return std::any_of(whole->edges().begin(), whole->edges().end(), [&](const Edge& edge) {
            return whole->vertices()[edge.from] == from && whole->vertices()[edge.to] == to;
        });
    };
    for (const ConvexPart& part : parts.parts) {
        const Polygon& polygon = std::get<Polygon>(part.shape);
        for (const Edge& edge : polygon.edges()) {
            result.push_back(is_side(polygon.vertices()[edge.from], polygon.vertices()[edge.to]) ? 1 : 0);
        }
    }
    return result;
}

} // namespace

RestEngine::RestEngine(std::vector<RestBody> bodies, const RestOptions& options, double time)
    : bodies_(std::move(bodies)), options_(options), start_(time)
{
    const std::size_t count = bodies_.size();
    for (RestBody& body : bodies_) {
        body.state.time = time;
        shapes_.push_back(make_collision_shape(body.shape));
        real_edges_.push_back(real_edges(body.shape, shapes_.back()));
        radius_.push_back(bounding_radius(body.shape));
        poses_.push_back(pose_of(body.state));
        movers_.push_back(mover_of(body));
    }
    before_ = movers_;
    place_movers_ = movers_;
    shift_.assign(count, Vec2::Zero());
    turn_.assign(count, 0.0);
    pull_.assign(count, Vec2::Zero());
    turn_pull_.assign(count, 0.0);
    for (std::size_t k = 0; k < count; ++k) expect_flight(static_cast<int>(k));
    reach_.assign(count, 0.0);
    parent_.assign(count, 0);
    slot_.assign(count, -1);
    asleep_.assign(count, 0);
    still_.assign(count, 0);
    sleep_group_.assign(count, -1);
}

void RestEngine::expect_flight(int body)
{
    pull_[body] = bodies_[body].is_static ? Vec2(Vec2::Zero()) : bodies_[body].acceleration;
    turn_pull_[body] = 0.0;
}

void RestEngine::advance(double time)
{
    // A step whose end is `time` but for rounding still fits
    const double last = time + 0.5 * tolerance::k_coordinate_roundings * tolerance::k_epsilon * std::abs(time);
    while (start_ + static_cast<double>(steps_ + 1) * options_.step <= last) step();
}

// [rest.step]
void RestEngine::step()
{
    Stopwatch watch(options_.seconds);
    measure_reach();
    if (pairs_.update(bodies_, shapes_, radius_, reach_)) ++counts_.looks;
    watch.stop(seconds_.pairs);

    do collide();
    while (wake_touched());
    watch.stop(seconds_.collide);

    gather_groups();
    for (Group& group : groups_) solve_group(group);
    watch.stop(seconds_.solve);

    for (const Group& group : groups_) move_group(group);
    ++steps_;
    ++counts_.steps;
    watch.stop(seconds_.move);
}
// [rest.step]

// [rest.reach]
void RestEngine::measure_reach()
{
    const double dt = options_.step;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const RestBody& body = bodies_[k];
        if (asleep_[k]) ++counts_.asleep;
        if (body.is_static || asleep_[k] || !body.is_active) continue;
        const double speed = body.state.velocity.norm() + std::abs(body.state.spin) * radius_[k];
        reach_[k] = dt * (speed + dt * body.acceleration.norm()) + rest_tolerance::k_watch * radius_[k];
        movers_[k] = mover_of(body);
        before_[k] = movers_[k];
        poses_[k] = pose_of(body.state);
        shift_[k] = Vec2::Zero();
        turn_[k] = 0.0;
    }
}
// [rest.reach]

double RestEngine::touch_gap(int a, int b) const
{
    const double coordinates =
        bodies_[a].state.position.cwiseAbs().maxCoeff() + bodies_[b].state.position.cwiseAbs().maxCoeff();
    return rest_tolerance::k_touch * std::min(radius_[a], radius_[b]) +
           tolerance::k_coordinate_roundings * tolerance::k_epsilon * coordinates;
}

// [rest.groups]
void RestEngine::gather_groups()
{
    // Join bodies that a point connects; a group's root is its lowest body
    const int count = static_cast<int>(bodies_.size());
    for (int k = 0; k < count; ++k) parent_[k] = k;
    const auto root = [&](int k) {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    };
    for (const ContactPoint& point : found_) {
        if (bodies_[point.a].is_static || bodies_[point.b].is_static) continue;
        const int one = root(point.a);
        const int two = root(point.b);
        parent_[std::max(one, two)] = std::min(one, two);
    }

    // Count members and points
    groups_.clear();
    for (int k = 0; k < count; ++k) {
        if (bodies_[k].is_static || asleep_[k] || !bodies_[k].is_active) continue;
        const int r = root(k);
        if (r == k) {
            slot_[k] = static_cast<int>(groups_.size());
            groups_.emplace_back();
        }
        ++groups_[slot_[r]].member_count;
    }
    const auto slot_of = [&](const ContactPoint& point) {
        return slot_[root(bodies_[point.a].is_static ? point.b : point.a)];
    };
    for (const ContactPoint& point : found_) ++groups_[slot_of(point)].point_count;
    int members = 0;
    int points = 0;
    for (Group& group : groups_) {
        group.first_member = members;
        group.first_point = points;
        members += group.member_count;
        points += group.point_count;
        group.member_count = group.point_count = 0;
    }

    // Lay them out, each group in the order of its bodies and pairs
    members_.resize(members);
    points_.resize(points);
    for (int k = 0; k < count; ++k) {
        if (bodies_[k].is_static || asleep_[k] || !bodies_[k].is_active) continue;
        Group& group = groups_[slot_[root(k)]];
        members_[group.first_member + group.member_count++] = k;
    }
    for (const ContactPoint& point : found_) {
        Group& group = groups_[slot_of(point)];
        points_[group.first_point + group.point_count++] = point;
    }
    counts_.groups += static_cast<std::int64_t>(groups_.size());
    counts_.points += points;
}
// [rest.groups]

void RestEngine::set_state(int body, const BodyState& state)
{
    bodies_[body].state = state;
    bodies_[body].state.time = time();
    poses_[body] = pose_of(state);
    expect_flight(body);
    pairs_.invalidate();
    wake_all_with(body);
}

void RestEngine::set_active(int body, bool active)
{
    if (bodies_[body].is_active == active) return;
    wake_all_with(body);
    bodies_[body].is_active = active;
    pairs_.invalidate();
}

void RestEngine::wake_all_with(int body)
{
    const auto wake = [&](int group) {
        if (group < 0) return;
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            if (sleep_group_[k] != group) continue;
            asleep_[k] = 0;
            sleep_group_[k] = -1;
        }
    };
    wake(sleep_group_[body]);
    for (const RestPair& pair : pairs_.pairs()) {
        if (pair.count == 0 || (pair.a != body && pair.b != body)) continue;
        wake(sleep_group_[pair.a]);
        wake(sleep_group_[pair.b]);
    }
}

std::vector<RestContact> RestEngine::contacts() const
{
    std::vector<RestContact> result;
    for (const RestPair& pair : pairs_.pairs()) {
        if (pair.count == 0) continue;
        const double margin = reach_[pair.a] + reach_[pair.b] + 2.0 * touch_gap(pair.a, pair.b);
        const Manifold manifold =
            make_manifold(shapes_[pair.a].parts[pair.part_a].shape, pose_of(bodies_[pair.a].state),
                          shapes_[pair.b].parts[pair.part_b].shape, pose_of(bodies_[pair.b].state), margin);
        for (int k = 0; k < pair.count; ++k) {
            for (int i = 0; i < manifold.count; ++i) {
                if (manifold.contacts[i].feature != pair.feature[k]) continue;
                result.push_back({pair.a, pair.b, manifold.contacts[i].normal, manifold.contacts[i].separation,
                                  pair.normal[k] / options_.step, pair.tangent[k] / options_.step});
            }
        }
    }
    return result;
}

std::vector<int> RestEngine::groups() const
{
    std::vector<int> group(bodies_.size());
    for (std::size_t k = 0; k < group.size(); ++k) group[k] = static_cast<int>(k);
    const auto root = [&](int k) {
        while (group[k] != k) k = group[k] = group[group[k]];
        return k;
    };
    for (const RestContact& contact : contacts()) {
        if (bodies_[contact.a].is_static || bodies_[contact.b].is_static) continue;
        if (contact.normal_force == 0.0 && contact.gap > touch_gap(contact.a, contact.b)) continue;
        const int one = root(contact.a);
        const int two = root(contact.b);
        group[std::max(one, two)] = std::min(one, two);
    }
    for (int k = 0; k < static_cast<int>(group.size()); ++k) {
        group[k] = bodies_[k].is_static || !bodies_[k].is_active ? -1 : root(k);
    }
    return group;
}

std::uint64_t RestEngine::hash() const
{
    Hash hash;
    for (const RestBody& body : bodies_) {
        const BodyState& s = body.state;
        for (const double x : {s.position.x(), s.position.y(), s.angle, s.velocity.x(), s.velocity.y(), s.spin})
            hash.add(x);
    }
    return hash.value();
}

} // namespace flying
