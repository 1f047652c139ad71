#include "rest/rest_engine.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "geometry/straight_vertices.hpp"
#include "math/hash.hpp"
#include "rest/body_order.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {


[[nodiscard]] Mover mover_of(const RestBody& body)
{
    if (body.is_static) return {};
    const BodyState& s = body.state;
    return {s.velocity.x(), s.velocity.y(), s.spin, body.inertia.inv_mass, body.inertia.inv_moment_of_inertia};
}



/// For each convex part, which of its edges are sides of the shape, and not cuts through it; empty where all are.
[[nodiscard]] std::vector<std::vector<char>> real_edges(const Shape& shape, const CollisionShape& parts)
{
    std::vector<std::vector<char>> result(parts.parts.size());
    const auto* whole = std::get_if<Polygon>(&shape);
    if (!whole || parts.parts.size() == 1) return result;
    for (std::size_t k = 0; k < result.size(); ++k) {
        const Polygon& polygon = std::get<Polygon>(parts.parts[k].shape);
        for (const Edge& edge : polygon.edges()) {
            result[k].push_back(has_straight_side(*whole, polygon.vertices()[edge.from], polygon.vertices()[edge.to]) ? 1 : 0);
        }
    }
    return result;
}


} // namespace


RestEngine::RestEngine(std::vector<RestBody> bodies, const RestOptions& options, double time)
    : RestEngine(bodies, options, time, order_in_memory(bodies, options.most_solved))
{
}

RestEngine::RestEngine(std::vector<RestBody> bodies, const RestOptions& options, double time, std::vector<int> order)
    : order_(std::move(order)), options_(options), start_(time)
{
    const std::size_t count = bodies.size();
    place_.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
        bodies_.push_back(std::move(bodies[order_[k]]));
        place_[order_[k]] = static_cast<int>(k);
    }
    for (RestBody& body : bodies_) {
        body.state.time = time;
        shapes_.push_back(make_collision_shape(body.shape));
        real_edges_.push_back(real_edges(body.shape, shapes_.back()));
        radius_.push_back(bounding_radius(body.shape));
        field_.push_back(body.acceleration);
        field_size_.push_back(body.acceleration.norm());
        turning_.push_back(body.is_static || std::holds_alternative<Disc>(body.shape) ? 0.0 : radius_.back());
        poses_.push_back(pose_of(body.state));
        movers_.push_back(mover_of(body));
    }
    solver_.set_warm(options_.warm_starts);
    before_ = movers_;
    place_movers_ = movers_;
    span_ = options_.step;
    next_poses_ = poses_;
    travel_.assign(count, Travel{});
    part_of_.assign(count, -1);
    is_inside_.assign(count, 0);
    shift_before_.assign(count, Vec2::Zero());
    turn_before_.assign(count, 0.0);
    shift_.assign(count, Vec2::Zero());
    turn_.assign(count, 0.0);
    pull_.assign(count, Vec2::Zero());
    turn_pull_.assign(count, 0.0);
    for (std::size_t k = 0; k < count; ++k) expect_flight(static_cast<int>(k), bodies_[k].state.position);
    reach_.assign(count, 0.0);
    parent_.assign(count, 0);
    slot_.assign(count, -1);
    asleep_.assign(count, 0);
    still_.assign(count, 0);
    in_crowd_.assign(count, 0);
    sleep_group_.assign(count, -1);
    find_fixed_seams();
}



void RestEngine::expect_flight(int body, const Vec2& place)
{
    pull_[body] = is_moved(body) ? field_at(body, place) : Vec2(Vec2::Zero());
    turn_pull_[body] = 0.0;
}



void RestEngine::advance(double time)
{
    // A step whose end is `time` but for rounding still fits
    const double last = time + 0.5 * tolerance::coordinate_rounding(std::abs(time));
    while (start_ + static_cast<double>(steps_ + 1) * options_.step <= last) step();
}



void RestEngine::measure_reach(std::span<const int> who)
{
    const double dt = span_;
    for (const int k : who) {
        aim_field(k);
        const RestBody& body = bodies_[k];
        const double speed = body.state.velocity.norm() + std::abs(body.state.spin) * radius_[k];
        reach_[k] = dt * (speed + dt * greatest_field(k, dt)) + rest_tolerance::k_watch * radius_[k];
        // What would carry a body beyond its reach in a part of a step was no load: it was taken from a shorter one
        const double more = 0.5 * (dt * dt) * (pull_[k].norm() + std::abs(turn_pull_[k]) * radius_[k]);
        const double room = reach_[k] - dt * speed;
        if (!std::isfinite(more)) expect_flight(k, body.state.position);
        else if (dt < options_.step && more > room) {
            pull_[k] *= room / more;
            turn_pull_[k] *= room / more;
        }
        movers_[k] = mover_of(body);
        before_[k] = movers_[k];
        set_pose(k, pose_of(body.state));
        shift_[k] = Vec2::Zero();
        turn_[k] = 0.0;
    }
}



double RestEngine::touch_gap(int a, int b) const
{
    return touch_gap(a, bodies_[a].state.position, b, bodies_[b].state.position);
}

double RestEngine::touch_gap(int a, const Vec2& place_a, int b, const Vec2& place_b) const
{
    const double coordinates = place_a.cwiseAbs().maxCoeff() + place_b.cwiseAbs().maxCoeff();
    return rest_tolerance::k_touch * std::min(radius_[a], radius_[b]) +
           tolerance::coordinate_rounding(coordinates);
}



void RestEngine::set_state(int number, const BodyState& state)
{
    const int body = place_[number];
    bodies_[body].state = state;
    bodies_[body].state.time = time();
    set_pose(body, pose_of(state));
    next_poses_[body] = poses_[body];
    expect_flight(body, state.position);
    pairs_.invalidate();
    wake_all_with(body);
}

void RestEngine::set_active(int number, bool active)
{
    const int body = place_[number];
    if (bodies_[body].is_active == active) return;
    wake_all_with(body);
    bodies_[body].is_active = active;
    pairs_.invalidate();
}

void RestEngine::wake_all_with(int body)
{
    sleepers_ = -1;
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
        const Manifold manifold = look(pair, pose_of(bodies_[pair.a].state), pose_of(bodies_[pair.b].state), margin);
        for (int k = 0; k < pair.count; ++k) {
            for (int i = 0; i < manifold.count; ++i) {
                if (manifold.contacts[i].feature != pair.feature[k]) continue;
                result.push_back({order_[pair.a], order_[pair.b], manifold.contacts[i].normal,
                                  manifold.contacts[i].separation, pair.normal[k] / options_.step,
                                  pair.tangent[k] / options_.step});
                RestContact& contact = result.back();
                if (contact.a < contact.b) continue;
                std::swap(contact.a, contact.b);
                contact.normal = -contact.normal;
            }
        }
    }
    std::stable_sort(result.begin(), result.end(), [](const RestContact& one, const RestContact& two) {
        return std::tie(one.a, one.b) < std::tie(two.a, two.b);
    });
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
        if (body(contact.a).is_static || body(contact.b).is_static) continue;
        if (contact.normal_force == 0.0 && contact.gap > touch_gap(place_[contact.a], place_[contact.b])) continue;
        const int one = root(contact.a);
        const int two = root(contact.b);
        group[std::max(one, two)] = std::min(one, two);
    }
    for (int k = 0; k < static_cast<int>(group.size()); ++k) {
        group[k] = body(k).is_static || !body(k).is_active ? -1 : root(k);
    }
    return group;
}



std::uint64_t RestEngine::hash() const
{
    Hash hash;
    for (const int place : place_) {
        const BodyState& s = bodies_[place].state;
        for (const double x : {s.position.x(), s.position.y(), s.angle, s.velocity.x(), s.velocity.y(), s.spin})
            hash.add(x);
    }
    return hash.value();
}


} // namespace flying
