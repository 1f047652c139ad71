#include "collide/separation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collide/separating_axis.hpp"
#include "geometry/convex_parts.hpp"
#include "geometry/straight_vertices.hpp"
#include "math/tolerance.hpp"

namespace flying {

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// Pairs of a vertex and an edge from which on it pays to look for the few that matter.
constexpr std::size_t k_slab_pays = 200;

/// Distance of a point from an edge, its ends included.  [m]
double distance_to_edge(const Vec2& point, const Polygon& polygon, const Edge& edge)
{
    const Vec2 from_start = point - polygon.vertices()[edge.from];
    const double along = edge.tangent.dot(from_start);
    if (along <= 0.0) return from_start.norm();
    if (along >= edge.length) return (point - polygon.vertices()[edge.to]).norm();
    return std::abs(cross(edge.tangent, from_start));
}

/// Signed distance of a point from a convex polygon, negative inside.  [m]
double distance_to_convex(const Vec2& point, const Polygon& polygon)
{
    // Inside, the nearest line is that of the nearest edge
    double nearest_line = -k_infinity;
    for (const Edge& edge : polygon.edges()) {
        const Vec2 from_start = point - polygon.vertices()[edge.from];
        nearest_line = std::max(nearest_line, edge.normal.dot(from_start));
    }
    if (nearest_line <= 0.0) return nearest_line;

    double distance = k_infinity;
    for (const Edge& edge : polygon.edges()) distance = std::min(distance, distance_to_edge(point, polygon, edge));
    return distance;
}

/// Where the ends of the shortest way between two polygons can lie: on the polygon from a height upwards, on the other
/// up to a height.
struct Slab
{
    Vec2 up = Vec2::Zero();            ///< in the polygon's frame
    double polygon_from = -k_infinity; ///< [m]
    double other_up_to = k_infinity;   ///< [m]
};

/// The point of a convex polygon's boundary that is nearest to a point.
Vec2 nearest_on(const Polygon& polygon, const Vec2& point)
{
    Vec2 nearest = polygon.vertices()[0];
    double least = k_infinity;
    for (const Edge& edge : polygon.edges()) {
        const Vec2& start = polygon.vertices()[edge.from];
        const double along = std::clamp(edge.tangent.dot(point - start), 0.0, edge.length);
        const Vec2 candidate = start + along * edge.tangent;
        const double distance = (point - candidate).squaredNorm();
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

/// A slab that leaves few features of two convex polygons with many. Going to and fro between them a few times, from
/// where the axis of greatest separation says, finds a short way; whatever lies behind its ends by more than it could
/// be shortened is out of the question.
Slab slab_between(const Polygon& a, const Polygon& b, const Pose& a_from_b, const Axis& axis, double rounding)
{
    const Pose b_from_a = relative_pose(a_from_b, Pose());
    Vec2 on_a = axis.owner == Owner::b ? a.vertices()[axis.vertex] : a.vertices()[axis.edge];
    Vec2 on_b = Vec2::Zero();
    for (int round = 0; round < 2; ++round) {
        on_b = a_from_b * nearest_on(b, b_from_a * on_a);
        on_a = nearest_on(a, on_b);
    }
    const double length = (on_b - on_a).norm();
    if (!(length > rounding)) return {};

    const Vec2 up = (on_b - on_a) / length;
    double top_of_a = -k_infinity;
    double bottom_of_b = k_infinity;
    for (const Vec2& vertex : a.vertices()) top_of_a = std::max(top_of_a, up.dot(vertex));
    for (const Vec2& vertex : b.vertices()) bottom_of_b = std::min(bottom_of_b, up.dot(a_from_b * vertex));
    const double slack = length - (bottom_of_b - top_of_a) + rounding;
    return {up, top_of_a - slack, bottom_of_b + slack};
}

/// Least distance of any vertex of `other` from any edge of `polygon`, both as far as the slab lets them in.  [m]
double vertices_to_edges(const Polygon& polygon, const Polygon& other, const Pose& polygon_from_other, const Slab& slab)
{
    double distance = k_infinity;
    for (const Vec2& vertex : other.vertices()) {
        const Vec2 point = polygon_from_other * vertex;
        if (slab.up.dot(point) > slab.other_up_to) continue;
        for (const Edge& edge : polygon.edges()) {
            const bool is_in = slab.up.dot(polygon.vertices()[edge.from]) >= slab.polygon_from ||
                               slab.up.dot(polygon.vertices()[edge.to]) >= slab.polygon_from;
            if (is_in) distance = std::min(distance, distance_to_edge(point, polygon, edge));
        }
    }
    return distance;
}

/// Distance between the boundaries of two convex polygons that are apart.  [m]
double distance_apart(const Polygon& a, const Polygon& b, const Pose& a_from_b, const Axis& axis, double rounding)
{
    const Pose b_from_a = relative_pose(a_from_b, Pose());
    Slab from_a;
    if (a.vertices().size() * b.vertices().size() > k_slab_pays) {
        from_a = slab_between(a, b, a_from_b, axis, rounding);
    }

    // Seen from B the slab is upside down, and its heights count from B's origin
    const double origin_b = from_a.up.dot(a_from_b.position);
    const Slab from_b = {b_from_a.rotation * Vec2(-from_a.up), origin_b - from_a.other_up_to,
                         origin_b - from_a.polygon_from};
    const double b_to_a = vertices_to_edges(a, b, a_from_b, from_a);
    const double a_to_b = vertices_to_edges(b, a, b_from_a, from_b);
    return std::min(b_to_a, a_to_b);
}

/// Signed distance between convex polygons.
double between_polygons(const Polygon& a, const Pose& world_from_a, const Polygon& b, const Pose& world_from_b)
{
    // Ask the axes how deep the two overlap, if they do
    const Pose a_from_b = relative_pose(world_from_a, world_from_b);
    const Axis axis = greatest_separation(a, b, a_from_b);
    const double along_axis = axis.separation;
    const double extent = a_from_b.position.norm() + a.radius() + b.radius();
    const double rounding = tolerance::coordinate_rounding(extent);
    if (along_axis < -rounding) return along_axis;

    // Apart, the shortest way starts or ends at a vertex
    const double distance = distance_apart(a, b, a_from_b, axis, rounding);
    if (along_axis > rounding) return std::max(along_axis, distance);

    // Between, the two touch; or thin ones lie end to end, whose own normals hardly look along them
    return distance > rounding ? distance : along_axis;
}

double between(const Disc& a, const Pose& world_from_a, const Disc& b, const Pose& world_from_b)
{
    return (world_from_b.position - world_from_a.position).norm() - (a.radius + b.radius);
}

double between(const Polygon& a, const Pose& world_from_a, const Disc& b, const Pose& world_from_b)
{
    const Vec2 centre = inverse(world_from_a.rotation) * Vec2(world_from_b.position - world_from_a.position);
    return distance_to_convex(centre, a) - b.radius;
}

double between(const HalfPlane& a, const Pose&, const Disc& b, const Pose& world_from_b)
{
    return (a.normal.dot(world_from_b.position) - a.offset) - b.radius;
}

double between(const HalfPlane& a, const Pose&, const Polygon& b, const Pose& world_from_b)
{
    const Vec2 normal = inverse(world_from_b.rotation) * a.normal;
    double lowest = k_infinity;
    for (const Vec2& vertex : b.vertices()) lowest = std::min(lowest, normal.dot(vertex));
    return (a.normal.dot(world_from_b.position) - a.offset) + lowest;
}

/// Signed distance between two convex shapes of any kind.
double between(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b)
{
    const auto* disc_a = std::get_if<Disc>(&a);
    const auto* disc_b = std::get_if<Disc>(&b);
    const auto* polygon_a = std::get_if<Polygon>(&a);
    const auto* polygon_b = std::get_if<Polygon>(&b);
    if (disc_a && disc_b) return between(*disc_a, world_from_a, *disc_b, world_from_b);
    if (polygon_a && polygon_b) return between_polygons(*polygon_a, world_from_a, *polygon_b, world_from_b);
    if (polygon_a && disc_b) return between(*polygon_a, world_from_a, *disc_b, world_from_b);
    if (disc_a && polygon_b) return between(*polygon_b, world_from_b, *disc_a, world_from_a);

    const auto* plane_a = std::get_if<HalfPlane>(&a);
    const auto* plane_b = std::get_if<HalfPlane>(&b);
    if (plane_a && disc_b) return between(*plane_a, world_from_a, *disc_b, world_from_b);
    if (plane_a && polygon_b) return between(*plane_a, world_from_a, *polygon_b, world_from_b);
    if (plane_b && disc_a) return between(*plane_b, world_from_b, *disc_a, world_from_a);
    if (plane_b && polygon_a) return between(*plane_b, world_from_b, *polygon_a, world_from_a);
    return k_infinity;
}

} // namespace

CollisionShape make_collision_shape(const Shape& shape)
{
    CollisionShape result;
    const auto* polygon = std::get_if<Polygon>(&shape);
    if (!polygon) {
        result.parts.push_back({shape, Vec2::Zero(), bounding_radius(shape)});
        return result;
    }
    for (const Polygon& cut : convex_parts(*polygon)) {
        Polygon part = without_straight_vertices(cut);
        // Put the circle's centre into the middle of the part's box
        Vec2 low = part.vertices()[0];
        Vec2 high = low;
        for (const Vec2& vertex : part.vertices()) {
            low = low.cwiseMin(vertex);
            high = high.cwiseMax(vertex);
        }
        const Vec2 centre = 0.5 * (low + high);
        double radius = 0.0;
        for (const Vec2& vertex : part.vertices()) radius = std::max(radius, (vertex - centre).norm());
        result.parts.push_back({std::move(part), centre, radius});
    }
    return result;
}

double separation(const CollisionShape& a, const Pose& world_from_a, const CollisionShape& b, const Pose& world_from_b)
{
    double least = k_infinity;
    for (const ConvexPart& part_a : a.parts) {
        for (const ConvexPart& part_b : b.parts) {
            // Leave out parts whose circles are further apart than the nearest pair so far
            if (least < k_infinity) {
                const Vec2 offset = world_from_b.position - world_from_a.position;
                const Vec2 way = offset + world_from_b.rotation * part_b.centre - world_from_a.rotation * part_a.centre;
                if (way.norm() - part_a.radius - part_b.radius > least) continue;
            }
            least = std::min(least, between(part_a.shape, world_from_a, part_b.shape, world_from_b));
        }
    }
    return least;
}

double separation(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b)
{
    return separation(make_collision_shape(a), world_from_a, make_collision_shape(b), world_from_b);
}

} // namespace flying
