#include "rest/near_points.hpp"

#include <algorithm>
#include <optional>

#include "collide/manifold.hpp"
#include "collide/separating_axis.hpp"
#include "math/tolerance.hpp"
#include "rest/corner_ways.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// One of the two.
struct NearSide
{
    const Polygon& polygon;
    const Pose& pose;
};

/// What rounding leaves of distances between the two, whose coordinates reach as far as their places and their vertices
/// do: those of a long slab in the middle of the world are no smaller than elsewhere.  [m]
[[nodiscard]] double rounding_of(const NearSide& a, const NearSide& b)
{
    const double place = std::max(a.pose.position.cwiseAbs().maxCoeff(), b.pose.position.cwiseAbs().maxCoeff());
    return tolerance::coordinate_rounding(place + std::max(a.polygon.radius(), b.polygon.radius()));
}

/// The smaller one's size.  [m]
[[nodiscard]] double size_of(const NearSide& a, const NearSide& b)
{
    return std::min(a.polygon.radius(), b.polygon.radius());
}

/// The corner that is nearest to the edge of an axis is one of the points over it.
[[nodiscard]] bool has_nearest(const Manifold& manifold, const Axis& axis, double rounding)
{
    const double lowest = axis.separation + rounding;
    const auto is_lowest = [&](const Contact& contact) { return lowest < 0.0 || contact.separation <= lowest; };
    return std::any_of(manifold.contacts, manifold.contacts + manifold.count, is_lowest);
}

/// Where the lowest point is that of two corners which lie on each other, it goes along the middle of their ways.
void take_middle_way(const NearSide& a, const NearSide& b, Manifold& manifold)
{
    const bool is_second = manifold.count == 2 && manifold.contacts[1].separation < manifold.contacts[0].separation;
    const Contact lowest = manifold.contacts[is_second ? 1 : 0];

    // The corner over the edge, and the end of this that is nearer to it
    const auto [owner, vertex, over] = vertex_on_edge(lowest.feature);
    const bool of_b = owner == Owner::b;
    const NearSide& with_edge = of_b ? a : b;
    const NearSide& with_corner = of_b ? b : a;
    const Pose here_from_there = relative_pose(with_edge.pose, with_corner.pose);
    const Vec2 place = here_from_there * with_corner.polygon.vertices()[vertex];
    const Edge& edge = with_edge.polygon.edges()[over];
    const bool is_at_start = edge.tangent.dot(place - with_edge.polygon.vertices()[edge.from]) < 0.5 * edge.length;
    const int end = is_at_start ? edge.from : edge.to;
    const Vec2 way = place - with_edge.polygon.vertices()[end];
    const double beside = rest_tolerance::k_watch * size_of(a, b);
    if (way.norm() > beside) return;

    const double near = rest_tolerance::k_landed * size_of(a, b) + rounding_of(a, b);
    const WaysOut corners = here_from_there.rotation * ways_out(with_corner.polygon, vertex);
    const std::optional<Vec2> out = middle_way(ways_out(with_edge.polygon, end), corners, way, near);
    if (!out) return;
    const Vec2 normal = with_edge.pose.rotation * *out;
    Contact middle;
    middle.separation = out->dot(way);
    middle.normal = of_b ? normal : Vec2(-normal);
    middle.point = with_edge.pose * Vec2(place - (0.5 * middle.separation) * *out);
    middle.feature = lowest.feature;

    // Another point lies beside it, as where one box has tipped on another a little, or is the same
    const Contact other = manifold.contacts[is_second ? 0 : 1];
    const bool has_other = manifold.count == 2 && (other.point - middle.point).norm() > beside;
    manifold = {{middle, other}, has_other ? 2 : 1};
}

/// The axis of greatest separation, by the edges that are known to have it.
[[nodiscard]] Axis find_axis(const Polygon& a, const Polygon& b, const Pose& a_from_b, NearMemory& memory)
{
    if (!memory.knows_edges) memory.edges = best_edges(a, b, a_from_b);
    const Axis axis = greater_of(memory.edges, a, b, a_from_b);
    memory.separation = axis.separation;
    memory.knows_edges = memory.knows_separation = true;
    return axis;
}

} // namespace

double find_separation(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, NearMemory& memory)
{
    const auto* polygon_a = std::get_if<Polygon>(&a);
    const auto* polygon_b = std::get_if<Polygon>(&b);
    if (!polygon_a || !polygon_b) return 0.0;
    return find_axis(*polygon_a, *polygon_b, relative_pose(pose_a, pose_b), memory).separation;
}

std::optional<Manifold> near_points(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b,
                                    double margin, NearMemory& memory)
{
    const auto* polygon_a = std::get_if<Polygon>(&a);
    const auto* polygon_b = std::get_if<Polygon>(&b);
    if (!polygon_a || !polygon_b) return make_manifold(a, pose_a, b, pose_b, margin);
    const Pose a_from_b = relative_pose(pose_a, pose_b);
    const Axis axis = find_axis(*polygon_a, *polygon_b, a_from_b, memory);
    if (axis.separation > margin) return Manifold{}; // and no two points are nearer than that
    const NearSide side_a{*polygon_a, pose_a};
    const NearSide side_b{*polygon_b, pose_b};
    Manifold manifold = make_manifold(*polygon_a, pose_a, *polygon_b, pose_b, a_from_b, axis, margin);
    if (!has_nearest(manifold, axis, rounding_of(side_a, side_b))) return std::nullopt;
    take_middle_way(side_a, side_b, manifold);
    return manifold;
}

} // namespace flying
