#include "rest/near_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "collide/manifold.hpp"
#include "collide/separating_axis.hpp"
#include "math/tolerance.hpp"
#include "rest/corner_ways.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// Added to the number of a vertex and an edge, where the two overlap and the edge is the shortest way out, or where
/// the vertex is over an end of the edge.
constexpr std::uint32_t k_way_out = 0x80000000u;
constexpr std::uint32_t k_over_end = 0xc0000000u;

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

/// The way out of `side` over one of its edges that is the shortest for the other. The normal leads from the side to
/// the other.
/// owner  of the other
[[nodiscard]] Contact shortest_way_out(const NearSide& side, const NearSide& other, Owner owner)
{
    Contact best;
    best.separation = -std::numeric_limits<double>::infinity();
    const Pose side_from_other = relative_pose(side.pose, other.pose);
    for (int k = 0; k < static_cast<int>(side.polygon.edges().size()); ++k) {
        const Vec2& normal = side.polygon.edges()[k].normal;
        const int deepest = axis_of_edge(side.polygon, k, other.polygon, side_from_other).vertex;
        const Vec2 point = side_from_other * other.polygon.vertices()[deepest];
        const double separation = normal.dot(point - side.polygon.vertices()[k]);
        if (separation <= best.separation) continue;
        best.separation = separation;
        best.normal = side.pose.rotation * normal;
        best.point = side.pose * point - 0.5 * separation * best.normal;
        best.feature = k_way_out | feature_number({owner, deepest, k});
    }
    return best;
}

/// The shorter of the ways out of either of the two. The normal leads from `a` to `b`.
[[nodiscard]] Contact shortest_way_apart(const NearSide& a, const NearSide& b)
{
    const Contact out_of_a = shortest_way_out(a, b, Owner::b);
    Contact out_of_b = shortest_way_out(b, a, Owner::a);
    out_of_b.normal = -out_of_b.normal;
    return out_of_b.separation > out_of_a.separation ? out_of_b : out_of_a;
}

/// Where two that are apart are nearest to each other.
struct Nearest
{
    Contact contact;
    double square = std::numeric_limits<double>::infinity(); ///< of the distance [m^2]
};

/// Corners of one over edges of the other, ends of the edges included, nearer than what was found.
/// owner  of the corners
void look_at_corners(const NearSide& side, const NearSide& other, Owner owner, Nearest& nearest)
{
    const Polygon& polygon = side.polygon;
    const Polygon& there = other.polygon;
    const Pose side_from_other = relative_pose(side.pose, other.pose);
    for (int v = 0; v < static_cast<int>(there.vertices().size()); ++v) {
        const Vec2 corner = side_from_other * there.vertices()[v];
        for (int k = 0; k < static_cast<int>(polygon.edges().size()); ++k) {
            const Edge& edge = polygon.edges()[k];
            const Vec2 from_start = corner - polygon.vertices()[edge.from];
            const double along = edge.tangent.dot(from_start);
            if (along < 0.0) continue; // nearer to the edge before
            const bool is_over = along <= edge.length;
            const double height = edge.normal.dot(from_start);
            const Vec2 way = is_over ? Vec2(height * edge.normal) : Vec2(corner - polygon.vertices()[edge.to]);
            const double square = is_over ? height * height : way.squaredNorm();
            if (square >= nearest.square || (is_over && height <= 0.0)) continue;
            nearest.square = square;
            nearest.contact.separation = std::sqrt(square);
            nearest.contact.normal = side.pose.rotation * Vec2(way / nearest.contact.separation);
            nearest.contact.point = side.pose * Vec2(corner - 0.5 * way);
            nearest.contact.feature = feature_number({owner, v, k}) | (is_over ? 0u : k_over_end);
        }
    }
}

[[nodiscard]] Nearest nearest_points(const NearSide& a, const NearSide& b)
{
    Nearest nearest;
    look_at_corners(a, b, Owner::b, nearest);
    const double least = nearest.square;
    look_at_corners(b, a, Owner::a, nearest);
    if (nearest.square < least) nearest.contact.normal = -nearest.contact.normal;
    return nearest;
}

/// Where a manifold of two polygons is empty: what is nearest of them.
[[nodiscard]] Manifold nearest_of(const NearSide& a, const NearSide& b, double margin)
{
    Manifold manifold;
    const Nearest found = nearest_points(a, b);
    const double rounding = rounding_of(a, b);
    // A distance of rounding has no direction: the two touch, and an edge tells which way
    if (found.square <= rounding * rounding) manifold.contacts[manifold.count++] = shortest_way_apart(a, b);
    else if (found.contact.separation <= margin) manifold.contacts[manifold.count++] = found.contact;
    return manifold;
}

/// The points over the edge of an axis, or, where the corner that is nearest to that edge stands beyond its ends, and
/// so is none of them, what is nearest of the two.
[[nodiscard]] Manifold points_by_axis(const NearSide& a, const NearSide& b, const Pose& a_from_b, const Axis& axis,
                                      double margin)
{
    const Manifold manifold = make_manifold(a.polygon, a.pose, b.polygon, b.pose, a_from_b, axis, margin);
    const double lowest = axis.separation + rounding_of(a, b);
    for (int k = 0; k < manifold.count; ++k) {
        if (lowest < 0.0 || manifold.contacts[k].separation <= lowest) return manifold;
    }
    return nearest_of(a, b, margin);
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

Manifold near_points(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin)
{
    NearMemory nothing;
    return near_points(a, pose_a, b, pose_b, margin, nothing);
}

double find_separation(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, NearMemory& memory)
{
    const auto* polygon_a = std::get_if<Polygon>(&a);
    const auto* polygon_b = std::get_if<Polygon>(&b);
    if (!polygon_a || !polygon_b) return 0.0;
    return find_axis(*polygon_a, *polygon_b, relative_pose(pose_a, pose_b), memory).separation;
}

Manifold near_points(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin,
                     NearMemory& memory)
{
    const auto* polygon_a = std::get_if<Polygon>(&a);
    const auto* polygon_b = std::get_if<Polygon>(&b);
    if (!polygon_a || !polygon_b) return make_manifold(a, pose_a, b, pose_b, margin);
    const Pose a_from_b = relative_pose(pose_a, pose_b);
    const Axis axis = find_axis(*polygon_a, *polygon_b, a_from_b, memory);
    if (axis.separation > margin) return {}; // and no two points are nearer than that
    const NearSide side_a{*polygon_a, pose_a};
    const NearSide side_b{*polygon_b, pose_b};
    Manifold manifold = points_by_axis(side_a, side_b, a_from_b, axis, margin);
    if (manifold.count > 0) take_middle_way(side_a, side_b, manifold);
    return manifold;
}

} // namespace flying
