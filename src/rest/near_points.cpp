#include "rest/near_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collide/manifold.hpp"
#include "collide/separating_axis.hpp"
#include "math/tolerance.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// A normal that leads out of a part through a cut.
[[nodiscard]] bool leads_through_cut(const NearSide& side, const Vec2& outwards)
{
    if (side.real.empty()) return false;
    const auto& edges = std::get<Polygon>(side.shape).edges();
    const Vec2 local = inverse(side.pose.rotation) * outwards;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        if (!side.real[k] && (edges[k].normal - local).cwiseAbs().maxCoeff() < rest_tolerance::k_same_normal)
            return true;
    }
    return false;
}

/// The way out of `side` over one of its real sides that is the shortest for the other part; separation -infinity where
/// the part has no real side. The normal leads from the side to the other.
[[nodiscard]] Contact shortest_way_out(const NearSide& side, const NearSide& other)
{
    Contact best;
    best.separation = -std::numeric_limits<double>::infinity();
    const auto* polygon = std::get_if<Polygon>(&side.shape);
    if (!polygon || std::holds_alternative<HalfPlane>(other.shape)) return best;
    const Pose side_from_other = relative_pose(side.pose, other.pose);
    for (int k = 0; k < static_cast<int>(polygon->edges().size()); ++k) {
        if (!side.real.empty() && !side.real[k]) continue;
        const Vec2& normal = polygon->edges()[k].normal;
        Vec2 point = side_from_other.position; // the other's point furthest behind the edge
        if (const auto* disc = std::get_if<Disc>(&other.shape)) point -= disc->radius * normal;
        else {
            const Polygon& there = std::get<Polygon>(other.shape);
            point = side_from_other * there.vertices()[axis_of_edge(*polygon, k, there, side_from_other).vertex];
        }
        const double separation = normal.dot(point - polygon->vertices()[k]);
        if (separation <= best.separation) continue;
        best.separation = separation;
        best.normal = side.pose.rotation * normal;
        best.point = side.pose * point - 0.5 * separation * best.normal;
        best.feature = 0x80000000u | static_cast<std::uint32_t>(k) << 1;
    }
    return best;
}

/// The shorter of the ways out of either of the two. The normal leads from `a` to `b`.
[[nodiscard]] Contact shortest_way_apart(const NearSide& a, const NearSide& b)
{
    const Contact out_of_a = shortest_way_out(a, b);
    Contact out_of_b = shortest_way_out(b, a);
    out_of_b.normal = -out_of_b.normal;
    out_of_b.feature |= 1u;
    return out_of_b.separation > out_of_a.separation ? out_of_b : out_of_a;
}

/// Where two parts that are apart are nearest to each other, if it is no cut.
struct Nearest
{
    Contact contact;
    double square = std::numeric_limits<double>::infinity(); ///< of the distance [m^2]
    bool on_cut = false;
};

/// Corners of one part over edges of the other, ends of the edges included, nearer than what was found.
void look_at_corners(const NearSide& side, const NearSide& other, std::uint32_t owner, Nearest& nearest)
{
    const auto& polygon = std::get<Polygon>(side.shape);
    const auto& there = std::get<Polygon>(other.shape);
    const Pose side_from_other = relative_pose(side.pose, other.pose);
    for (std::size_t v = 0; v < there.vertices().size(); ++v) {
        const Vec2 corner = side_from_other * there.vertices()[v];
        for (std::size_t k = 0; k < polygon.edges().size(); ++k) {
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
            nearest.on_cut = is_over && !side.real.empty() && !side.real[k];
            nearest.contact.separation = std::sqrt(square);
            nearest.contact.normal = side.pose.rotation * Vec2(way / nearest.contact.separation);
            nearest.contact.point = side.pose * Vec2(corner - 0.5 * way);
            const std::uint32_t kind = is_over ? 0u : 0xc0000000u;
            nearest.contact.feature =
                kind | static_cast<std::uint32_t>(k) << 16 | static_cast<std::uint32_t>(v) << 1 | owner;
        }
    }
}

[[nodiscard]] Nearest nearest_points(const NearSide& a, const NearSide& b)
{
    Nearest nearest;
    look_at_corners(a, b, 1u, nearest);
    const double least = nearest.square;
    look_at_corners(b, a, 0u, nearest);
    if (nearest.square < least) nearest.contact.normal = -nearest.contact.normal;
    return nearest;
}

/// Leaves of a manifold of two parts what doesn't stand on cuts, and adds what is near beside it.
void keep_to_sides(const NearSide& a, const NearSide& b, double margin, Manifold& manifold)
{
    const bool are_polygons = std::holds_alternative<Polygon>(a.shape) && std::holds_alternative<Polygon>(b.shape);
    const auto add_nearest = [&] {
        const Nearest found = nearest_points(a, b);
        const double reach = std::max(a.pose.position.cwiseAbs().maxCoeff(), b.pose.position.cwiseAbs().maxCoeff());
        const double rounding = tolerance::coordinate_rounding(reach);
        // A distance of rounding has no direction: the two touch, and a side tells which way
        if (found.square <= rounding * rounding) {
            const Contact apart = shortest_way_apart(a, b);
            if (std::abs(apart.separation) <= rounding) manifold.contacts[manifold.count++] = apart;
        } else if (!found.on_cut && found.contact.separation <= margin)
            manifold.contacts[manifold.count++] = found.contact;
    };
    if (manifold.count == 0) {
        if (are_polygons) add_nearest();
        return;
    }
    if (a.real.empty() && b.real.empty()) return;
    const Vec2 normal = manifold.contacts[0].normal;
    if (!leads_through_cut(a, normal) && !leads_through_cut(b, -normal)) return;
    double depth = 0.0;
    for (int k = 0; k < manifold.count; ++k) depth = std::max(depth, -manifold.contacts[k].separation);
    manifold.count = 0;
    // Beyond the ends of a cut, as in a notch, something else is nearest
    if (depth == 0.0) {
        if (are_polygons) add_nearest();
        return;
    }

    // Out over a side, by the shortest way; a part between two cuts may have none that is near
    const Contact best = shortest_way_apart(a, b);
    if (depth >= -rest_tolerance::k_hardly_over_cut * best.separation) manifold.contacts[manifold.count++] = best;
}

} // namespace

Manifold near_points(const NearSide& a, const NearSide& b, double margin)
{
    Manifold manifold = make_manifold(a.shape, a.pose, b.shape, b.pose, margin);
    keep_to_sides(a, b, margin, manifold);
    return manifold;
}

Manifold near_points(const NearSide& a, const NearSide& b, double margin, NearMemory& memory)
{
    const auto* polygon_a = std::get_if<Polygon>(&a.shape);
    const auto* polygon_b = std::get_if<Polygon>(&b.shape);
    if (!polygon_a || !polygon_b) {
        const bool has_cuts = !a.real.empty() || !b.real.empty();
        return has_cuts ? near_points(a, b, margin) : make_manifold(a.shape, a.pose, b.shape, b.pose, margin);
    }
    const Pose a_from_b = relative_pose(a.pose, b.pose);
    if (!memory.knows_edges) memory.edges = best_edges(*polygon_a, *polygon_b, a_from_b);
    const Axis axis = greater_of(memory.edges, *polygon_a, *polygon_b, a_from_b);
    memory.separation = axis.separation;
    memory.knows_edges = memory.knows_separation = true;
    if (axis.separation > margin) return {}; // and no two points are nearer than that
    Manifold manifold = make_manifold(*polygon_a, a.pose, *polygon_b, b.pose, a_from_b, axis, margin);
    keep_to_sides(a, b, margin, manifold);
    return manifold;
}

} // namespace flying
