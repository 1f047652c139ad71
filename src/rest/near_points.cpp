#include "rest/near_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collide/manifold.hpp"
#include "collide/separating_axis.hpp"

namespace flying {
namespace {

// [rest.near.cut]
/// [sine] Normals this near are those of one edge.
constexpr double k_same_normal = 0x1p-10;

/// A normal that leads out of a part through a cut.
[[nodiscard]] bool leads_through_cut(const NearSide& side, const Vec2& outwards)
{
    if (side.real.empty()) return false;
    const auto& edges = std::get<Polygon>(side.shape).edges();
    const Vec2 local = inverse(side.pose.rotation) * outwards;
    for (std::size_t k = 0; k < edges.size(); ++k) {
        if (!side.real[k] && (edges[k].normal - local).cwiseAbs().maxCoeff() < k_same_normal) return true;
    }
    return false;
}
// [rest.near.cut]

// [rest.near.out]
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
// [rest.near.out]

// [rest.near.corners]
/// The nearest two corners of two polygons that are apart.
[[nodiscard]] Contact nearest_corners(const Polygon& a, const NearSide& side_a, const Polygon& b,
                                      const NearSide& side_b)
{
    Contact best;
    double least = std::numeric_limits<double>::infinity();
    const Pose a_from_b = relative_pose(side_a.pose, side_b.pose);
    Vec2 way = Vec2::Zero();
    Vec2 from = Vec2::Zero();
    for (std::size_t j = 0; j < b.vertices().size(); ++j) {
        const Vec2 there = a_from_b * b.vertices()[j];
        for (std::size_t i = 0; i < a.vertices().size(); ++i) {
            const double square = (there - a.vertices()[i]).squaredNorm();
            if (square >= least) continue;
            least = square;
            from = a.vertices()[i];
            way = there - from;
            best.feature = 0xc0000000u | static_cast<std::uint32_t>(i) << 15 | static_cast<std::uint32_t>(j);
        }
    }
    best.separation = std::sqrt(least);
    if (!(best.separation > 0.0)) return best;
    best.normal = side_a.pose.rotation * Vec2(way / best.separation);
    best.point = side_a.pose * Vec2(from + 0.5 * way);
    return best;
}
// [rest.near.corners]

} // namespace

// [rest.near]
Manifold near_points(const NearSide& a, const NearSide& b, double margin)
{
    Manifold manifold = make_manifold(a.shape, a.pose, b.shape, b.pose, margin);
    const auto* polygon_a = std::get_if<Polygon>(&a.shape);
    const auto* polygon_b = std::get_if<Polygon>(&b.shape);
    if (manifold.count == 0 && polygon_a && polygon_b) {
        const Contact corners = nearest_corners(*polygon_a, a, *polygon_b, b);
        if (corners.separation > 0.0 && corners.separation <= margin) manifold.contacts[manifold.count++] = corners;
        return manifold;
    }
    if (manifold.count == 0 || (a.real.empty() && b.real.empty())) return manifold;
    const Vec2 normal = manifold.contacts[0].normal;
    if (!leads_through_cut(a, normal) && !leads_through_cut(b, -normal)) return manifold;
    const bool overlaps = std::any_of(manifold.contacts, manifold.contacts + manifold.count,
                                      [](const Contact& contact) { return contact.separation < 0.0; });
    manifold.count = 0;
    if (!overlaps) return manifold;

    // Out over a side, by the shortest way
    const Contact out_of_a = shortest_way_out(a, b);
    Contact out_of_b = shortest_way_out(b, a);
    out_of_b.normal = -out_of_b.normal;
    out_of_b.feature |= 1u;
    const Contact& best = out_of_b.separation > out_of_a.separation ? out_of_b : out_of_a;
    if (std::isfinite(best.separation)) manifold.contacts[manifold.count++] = best;
    return manifold;
}
// [rest.near]

} // namespace flying
