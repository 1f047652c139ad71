#include "collide/manifold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collide/separating_axis.hpp"

namespace flying {

namespace {

/// One contact of two surfaces: `point` lies on the second, `separation` away from the
/// first along the normal.
Contact contact_at(const Vec2& point, const Vec2& normal, double separation,
                   std::uint32_t feature)
{
    return {point - 0.5 * separation * normal, normal, separation, feature};
}

void add(Manifold& manifold, const Contact& contact)
{
    manifold.contacts[manifold.count] = contact;
    ++manifold.count;
}

/// The same contacts with A and B exchanged. Features name their owners, and are renamed.
Manifold swapped(Manifold manifold)
{
    for (int k = 0; k < manifold.count; ++k) {
        Contact& contact = manifold.contacts[k];
        contact.normal = -contact.normal;
        contact.feature ^= 1u;
    }
    return manifold;
}

/// [lengths of the edge] A clipped edge is as low as its lowest vertex if it differs by less.
constexpr double k_level = 0x1p-16;

/// An end of the clipped edge.
struct ClippedEnd
{
    Vec2 point = Vec2::Zero(); ///< in the reference polygon's frame
    double along = 0.0;        ///< along the reference edge, from its start [m]
    bool is_cut = false;       ///< it lies at the end of the reference edge
    int vertex = 0;            ///< of the incident polygon; where cut, of the reference
};

/// Where the straight line between two ends stands at `along`.
ClippedEnd cut_at(const ClippedEnd& from, const ClippedEnd& to, double along, int vertex)
{
    const double part = (along - from.along) / (to.along - from.along);
    return {from.point + part * (to.point - from.point), along, true, vertex};
}

/// Of the two edges at the vertex furthest behind, the one that faces the edge more.
int facing_edge(const Polygon& incident, int vertex, const Vec2& normal_in_incident)
{
    const int before = incident.previous(vertex);
    const double faces_before = normal_in_incident.dot(incident.edges()[before].normal);
    const double faces_after = normal_in_incident.dot(incident.edges()[vertex].normal);
    return faces_before < faces_after ? before : vertex;
}

/// Contacts of two convex polygons, normals from the reference polygon to the other.
Manifold clip(const Polygon& reference, const Pose& world_from_reference, const Polygon& incident,
              const Pose& reference_from_incident, const Axis& axis, double margin)
{
    const Edge& edge = reference.edges()[axis.edge];
    const Vec2& start = reference.vertices()[edge.from];
    const Vec2 normal_in_incident = inverse(reference_from_incident.rotation) * edge.normal;
    const int facing = facing_edge(incident, axis.vertex, normal_in_incident);

    // [collide.manifold.polygons.ends]
    // Write down the facing edge as the reference edge sees it: it runs the other way
    const auto end_at = [&](int vertex) {
        const Vec2 point = reference_from_incident * incident.vertices()[vertex];
        return ClippedEnd{point, edge.tangent.dot(point - start), false, vertex};
    };
    ClippedEnd low = end_at(incident.edges()[facing].to);
    ClippedEnd high = end_at(incident.edges()[facing].from);
    if (low.along > high.along) std::swap(low, high);
    // [collide.manifold.polygons.ends]

    // [collide.manifold.polygons.cut]
    // Cut off what sticks out beyond the ends of the reference edge
    const bool misses = high.along < 0.0 || low.along > edge.length;
    if (misses) {
        if (axis.separation > 0.0) return {};
        low = high = end_at(axis.vertex);
    } else {
        const ClippedEnd whole_low = low;
        const ClippedEnd whole_high = high;
        if (whole_low.along < 0.0) low = cut_at(whole_low, whole_high, 0.0, edge.from);
        if (whole_high.along > edge.length)
            high = cut_at(whole_low, whole_high, edge.length, edge.to);
    }
    // [collide.manifold.polygons.cut]

    // Where that cut off the vertex that is furthest behind, and what is left lies far above it, take the vertex
    const auto height = [&](const ClippedEnd& end) { return edge.normal.dot(end.point - start); };
    double height_of_low = height(low);
    double height_of_high = height(high);
    if (std::min(height_of_low, height_of_high) > 2.0 * std::max(axis.separation, 0.0) + k_level * edge.length) {
        if (axis.separation > 0.0) return {};
        low = high = end_at(axis.vertex);
        height_of_low = height_of_high = height(low);
    }

    // [collide.manifold.polygons.keep]
    // Keep the ends that reach the reference edge, within the margin
    Manifold manifold;
    const Vec2 normal = world_from_reference.rotation * edge.normal;
    const auto keep = [&](const ClippedEnd& end, double separation) {
        if (separation > margin) return;
        const std::uint32_t feature = end.is_cut
                                          ? feature_number({Owner::a, end.vertex, facing})
                                          : feature_number({Owner::b, end.vertex, axis.edge});
        add(manifold,
            contact_at(world_from_reference * end.point, normal, separation, feature));
    };
    keep(low, height_of_low);
    if (manifold.count == 0 || high.point != low.point) keep(high, height_of_high);
    // [collide.manifold.polygons.keep]
    return manifold;
}

Manifold between(const Polygon& a, const Pose& world_from_a, const Polygon& b, const Pose& world_from_b, double margin)
{
    const Pose a_from_b = relative_pose(world_from_a, world_from_b);
    const Axis axis = greater_of(best_edges(a, b, a_from_b), a, b, a_from_b);
    return make_manifold(a, world_from_a, b, world_from_b, a_from_b, axis, margin);
}

Manifold between(const Disc& a, const Pose& world_from_a, const Disc& b, const Pose& world_from_b, double margin)
{
    const Vec2 way = world_from_b.position - world_from_a.position;
    const double distance = way.norm();
    const double separation = distance - (a.radius + b.radius);
    if (separation > margin) return {};

    // Discs with one centre can part in any direction
    const Vec2 normal = distance > 0.0 ? Vec2(way / distance) : Vec2(1.0, 0.0);
    Manifold manifold;
    add(manifold, contact_at(world_from_b.position - b.radius * normal, normal, separation, 0));
    return manifold;
}

Manifold between(const Polygon& a, const Pose& world_from_a, const Disc& b, const Pose& world_from_b, double margin)
{
    // Find the edge whose line the centre is furthest outside of
    const Vec2 centre = inverse(world_from_a.rotation) * Vec2(world_from_b.position - world_from_a.position);
    int nearest = 0;
    double outside = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < static_cast<int>(a.edges().size()); ++k) {
        const double height = a.edges()[k].normal.dot(centre - a.vertices()[k]);
        if (height > outside) {
            outside = height;
            nearest = k;
        }
    }

    // Inside, the shortest way out leads over that edge; outside, the nearest point of any edge decides
    Vec2 normal = a.edges()[nearest].normal;
    double distance = outside;
    std::uint32_t feature = feature_number({Owner::b, 0, nearest});
    if (outside > 0.0) {
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < static_cast<int>(a.edges().size()); ++k) {
            const Edge& edge = a.edges()[k];
            const Vec2 from_start = centre - a.vertices()[k];
            const double along = edge.tangent.dot(from_start);
            const bool is_corner = along <= 0.0;
            if (along >= edge.length) continue; // the next edge's start
            const double way = is_corner ? from_start.norm() : edge.normal.dot(from_start);
            if ((!is_corner && way < 0.0) || way >= least) continue;
            least = distance = way;
            normal = is_corner ? Vec2(from_start / way) : edge.normal;
            feature = is_corner ? feature_number({Owner::a, k, 0}) : feature_number({Owner::b, 0, k});
        }
    }

    const double separation = distance - b.radius;
    if (separation > margin) return {};

    const Vec2 normal_in_world = world_from_a.rotation * normal;
    Manifold manifold;
    add(manifold, contact_at(world_from_b.position - b.radius * normal_in_world, normal_in_world, separation, feature));
    return manifold;
}

Manifold between(const HalfPlane& a, const Pose&, const Disc& b, const Pose& world_from_b, double margin)
{
    const double separation = (a.normal.dot(world_from_b.position) - a.offset) - b.radius;
    Manifold manifold;
    if (separation > margin) return manifold;
    add(manifold, contact_at(world_from_b.position - b.radius * a.normal, a.normal, separation, 0));
    return manifold;
}

Manifold between(const HalfPlane& a, const Pose&, const Polygon& b, const Pose& world_from_b, double margin)
{
    const Vec2 normal = inverse(world_from_b.rotation) * a.normal;
    const double height = a.normal.dot(world_from_b.position) - a.offset;
    int lowest = 0;
    for (int v = 1; v < static_cast<int>(b.vertices().size()); ++v) {
        if (normal.dot(b.vertices()[v]) < normal.dot(b.vertices()[lowest])) lowest = v;
    }

    // The lowest vertex, and its neighbour along the edge that faces the wall more
    const int facing = facing_edge(b, lowest, normal);
    const int other = facing == lowest ? b.edges()[lowest].to : facing;
    Manifold manifold;
    for (const int vertex : {lowest, other}) {
        const double separation = height + normal.dot(b.vertices()[vertex]);
        if (separation > margin) continue;
        const Vec2 point = world_from_b * b.vertices()[vertex];
        add(manifold, contact_at(point, a.normal, separation, feature_number({Owner::b, vertex, 0})));
    }
    return manifold;
}

} // namespace

Manifold make_manifold(const Polygon& a, const Pose& world_from_a, const Polygon& b, const Pose& world_from_b,
                       const Pose& a_from_b, const Axis& axis, double margin)
{
    if (axis.separation > margin) return {};
    if (axis.owner == Owner::a) return clip(a, world_from_a, b, a_from_b, axis, margin);
    return swapped(clip(b, world_from_b, a, relative_pose(world_from_b, world_from_a), axis, margin));
}

Manifold make_manifold(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b,
                       double margin)
{
    const auto* disc_a = std::get_if<Disc>(&a);
    const auto* disc_b = std::get_if<Disc>(&b);
    const auto* polygon_a = std::get_if<Polygon>(&a);
    const auto* polygon_b = std::get_if<Polygon>(&b);
    if (disc_a && disc_b) return between(*disc_a, world_from_a, *disc_b, world_from_b, margin);
    if (polygon_a && polygon_b) return between(*polygon_a, world_from_a, *polygon_b, world_from_b, margin);
    if (polygon_a && disc_b) return between(*polygon_a, world_from_a, *disc_b, world_from_b, margin);

    const auto* plane_a = std::get_if<HalfPlane>(&a);
    if (plane_a && disc_b) return between(*plane_a, world_from_a, *disc_b, world_from_b, margin);
    if (plane_a && polygon_b) return between(*plane_a, world_from_a, *polygon_b, world_from_b, margin);

    // What is left has its kinds the other way round
    const bool is_left = (disc_a && !disc_b) || (polygon_a && std::holds_alternative<HalfPlane>(b));
    return is_left ? swapped(make_manifold(b, world_from_b, a, world_from_a, margin)) : Manifold{};
}

} // namespace flying
