#include "rest/rest_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/stoutness.hpp"
#include "geometry/straight_vertices.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// For each convex part, which of its edges are sides of the shape, and not cuts through it; empty where all are.
[[nodiscard]] std::vector<std::vector<char>> real_edges_of(const Shape& shape, const CollisionShape& parts)
{
    std::vector<std::vector<char>> result(parts.parts.size());
    const auto* whole = std::get_if<Polygon>(&shape);
    if (!whole || parts.parts.size() == 1) return result;
    for (std::size_t k = 0; k < result.size(); ++k) {
        const Polygon& polygon = std::get<Polygon>(parts.parts[k].shape);
        for (const Edge& edge : polygon.edges()) {
            const bool is_real = has_straight_side(*whole, polygon.vertices()[edge.from], polygon.vertices()[edge.to]);
            result[k].push_back(is_real ? 1 : 0);
        }
    }
    return result;
}

} // namespace

RestBodies::RestBodies(std::vector<RestBody> bodies, std::vector<int> numbers, double time) : order(std::move(numbers))
{
    place.resize(bodies.size());
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        list.push_back(std::move(bodies[order[k]]));
        place[order[k]] = static_cast<int>(k);
    }
    for (RestBody& body : list) {
        body.state.time = time;
        shapes.push_back(make_collision_shape(body.shape));
        outlines.emplace_back(body.shape, shapes.back());
        real_edges.push_back(real_edges_of(body.shape, shapes.back()));
        radius.push_back(bounding_radius(body.shape));
        breadth.push_back(std::min(radius.back(), stoutness(body.shape)));
        turning.push_back(body.is_static || std::holds_alternative<Disc>(body.shape) ? 0.0 : radius.back());
        poses.push_back(pose_of(body.state));
        angles.push_back(body.state.angle);
    }
    travel.assign(list.size(), Travel{});
    moves.assign(list.size(), 0);
    in_large_island.assign(list.size(), 0);
}

void RestBodies::set_pose(int body, const BodyState& state)
{
    const Pose& old = poses[body];
    if (old.position == state.position && angles[body] == state.angle) return;
    const Pose pose = pose_of(state);
    travel[body].shift += (pose.position - old.position).cwiseAbs().sum();
    travel[body].turn +=
        std::abs(pose.rotation.cosine - old.rotation.cosine) + std::abs(pose.rotation.sine - old.rotation.sine);
    poses[body] = pose;
    angles[body] = state.angle;
    ++moves[body];
}

double RestBodies::touch_gap(int a, int b) const
{
    return touch_gap(a, list[a].state.position, b, list[b].state.position);
}

double RestBodies::touch_gap(int a, const Vec2& place_a, int b, const Vec2& place_b) const
{
    const double coordinates = place_a.cwiseAbs().maxCoeff() + place_b.cwiseAbs().maxCoeff();
    return rest_tolerance::k_touch * size_of(a, b) + tolerance::coordinate_rounding(coordinates);
}

} // namespace flying
