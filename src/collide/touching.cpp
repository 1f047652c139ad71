#include "collide/touching.hpp"

#include <algorithm>
#include <cmath>

namespace flying {
namespace {

/// Two bodies at one moment, and where their touches go. `b_from_a` leads from B's position to A's. [m]
struct Pair
{
    const Pose& world_from_a;
    const Pose& world_from_b;
    Vec2 b_to_a;
    double tolerance;
    std::vector<Touch>& touches;
};

/// A touch at r_a from A.
void add(const Pair& pair, const Vec2& r_a, const Vec2& normal, double separation, const Feature& feature)
{
    pair.touches.push_back({r_a, r_a + pair.b_to_a, normal, separation, feature});
}

/// The same pair seen from B, for functions that want its bodies the other way round.
void mirror(std::vector<Touch>& touches, std::size_t first)
{
    for (std::size_t k = first; k < touches.size(); ++k) {
        Touch& touch = touches[k];
        std::swap(touch.r_a, touch.r_b);
        touch.normal = -touch.normal;
        if (touch.feature.kind == FeatureKind::vertex_of_a) touch.feature.kind = FeatureKind::vertex_of_b;
        else if (touch.feature.kind == FeatureKind::vertex_of_b) touch.feature.kind = FeatureKind::vertex_of_a;
        else if (touch.feature.kind == FeatureKind::corner) std::swap(touch.feature.vertex, touch.feature.edge);
    }
}

void touch(const Pair& pair, const Disc& a, const Disc& b)
{
    const double distance = pair.b_to_a.norm();
    const double gap = distance - (a.radius + b.radius);
    if (gap > pair.tolerance || distance == 0.0) return;
    const Vec2 normal = -pair.b_to_a / distance;
    pair.touches.push_back({a.radius * normal, -b.radius * normal, normal, gap, {}});
}

void touch(const Pair& pair, const Disc& a, const HalfPlane& b)
{
    const double gap = b.normal.dot(pair.world_from_a.position) - b.offset - a.radius;
    if (gap > pair.tolerance) return;
    add(pair, -a.radius * b.normal, -b.normal, gap, {});
}

void touch(const Pair& pair, const Polygon& a, const HalfPlane& b)
{
    const double height = b.normal.dot(pair.world_from_a.position) - b.offset;
    for (int k = 0; k < static_cast<int>(a.vertices().size()); ++k) {
        if (a.is_reflex(k)) continue;
        const Vec2 r_a = pair.world_from_a.rotation * a.vertices()[k];
        const double gap = height + b.normal.dot(r_a);
        if (gap <= pair.tolerance) add(pair, r_a, -b.normal, gap, {FeatureKind::vertex_of_a, k, -1});
    }
}

/// Disc A on polygon B. The boundary of B is cut into edges and the wedges beyond its corners, so that each touch is
/// found once.
void touch(const Pair& pair, const Disc& a, const Polygon& b)
{
    const Rotation b_from_world = inverse(pair.world_from_b.rotation);
    const Vec2 centre = b_from_world * pair.b_to_a;
    for (const Edge& edge : b.edges()) {
        const Vec2 from_vertex = centre - b.vertices()[edge.from];
        const double along = edge.tangent.dot(from_vertex);

        // Between the ends, the nearest point is on the edge
        if (along >= 0.0 && along <= edge.length) {
            const double height = edge.normal.dot(from_vertex);
            const double gap = height - a.radius;
            if (height > 0.0 && gap <= pair.tolerance) {
                const Vec2 outwards = pair.world_from_b.rotation * edge.normal;
                add(pair, -a.radius * outwards, -outwards, gap, {FeatureKind::vertex_of_a, -1, edge.from});
            }
            continue;
        }

        // Before the start, and past the end of the edge before, it is the corner
        const Edge& before = b.edges()[b.previous(edge.from)];
        const bool past_before = before.tangent.dot(centre - b.vertices()[before.from]) > before.length;
        if (along >= 0.0 || !past_before || b.is_reflex(edge.from)) continue;
        const double distance = from_vertex.norm();
        const double gap = distance - a.radius;
        if (gap <= pair.tolerance && distance > 0.0) {
            const Vec2 outwards = pair.world_from_b.rotation * Vec2(from_vertex / distance);
            add(pair, -a.radius * outwards, -outwards, gap, {FeatureKind::vertex_of_b, edge.from, -1});
        }
    }
}

/// Unit normal, out of B, of a corner of A on a corner of B: the middle of the cone of directions along which they can
/// part. All arguments in one frame. Zero where no direction parts them.
///
/// a_in, a_out  unit tangents of A's edges into and out of its corner
/// b_in, b_out  the same of B
Vec2 corner_normal(const Vec2& a_in, const Vec2& a_out, const Vec2& b_in, const Vec2& b_out)
{
    // A direction parts them if both edges of A lie on its side, and both edges of B on the other
    constexpr double k_facing = 1e-9; // [rad] edges this close to parallel face each other
    const auto parts = [&](const Vec2& n) {
        return n.dot(a_out) >= -k_facing && -n.dot(a_in) >= -k_facing && n.dot(b_out) <= k_facing &&
               -n.dot(b_in) <= k_facing;
    };
    const auto outwards = [](const Vec2& tangent) { return Vec2(tangent.y(), -tangent.x()); };

    // The cone's sides are normals of edges: take the sum of the two that lie farthest apart
    const Vec2 candidates[] = {outwards(b_in), outwards(b_out), -outwards(a_in), -outwards(a_out)};
    Vec2 best = Vec2::Zero();
    double widest = 2.0;
    for (int i = 0; i < 4; ++i) {
        if (!parts(candidates[i])) continue;
        for (int j = i; j < 4; ++j) {
            if (!parts(candidates[j])) continue;
            const double cosine = candidates[i].dot(candidates[j]);
            if (cosine < widest) {
                widest = cosine;
                best = candidates[i] + candidates[j];
            }
        }
    }
    const double length = best.norm();
    return length > 0.0 ? Vec2(best / length) : best;
}

/// Vertices of A on the edges of B; with `corners`, also on its corners.
void touch_vertices(const Pair& pair, const Polygon& a, const Polygon& b, bool corners)
{
    const Rotation b_from_world = inverse(pair.world_from_b.rotation);
    const Rotation b_from_a = b_from_world * pair.world_from_a.rotation;
    for (int k = 0; k < static_cast<int>(a.vertices().size()); ++k) {
        if (a.is_reflex(k)) continue;
        const Vec2 r_a = pair.world_from_a.rotation * a.vertices()[k];
        const Vec2 vertex = b_from_world * Vec2(pair.b_to_a + r_a);
        if (vertex.norm() > b.radius() + pair.tolerance) continue;

        for (const Edge& edge : b.edges()) {
            const Vec2 from_vertex = vertex - b.vertices()[edge.from];
            const double gap = edge.normal.dot(from_vertex);
            if (std::abs(gap) > pair.tolerance) continue;
            const double along = edge.tangent.dot(from_vertex);

            // At a corner that sticks out, both edges share the touch
            const bool at_start = std::abs(along) <= pair.tolerance && !b.is_reflex(edge.from);
            const bool at_end = std::abs(along - edge.length) <= pair.tolerance && !b.is_reflex(edge.to);
            // [touching.vertex-on-corner]
            if (at_start && corners && from_vertex.norm() <= 2.0 * pair.tolerance) {
                const Vec2 normal =
                    corner_normal(b_from_a * a.edges()[a.previous(k)].tangent, b_from_a * a.edges()[k].tangent,
                                  b.edges()[b.previous(edge.from)].tangent, edge.tangent);
                if (normal != Vec2::Zero()) {
                    add(pair, r_a, -(pair.world_from_b.rotation * normal), normal.dot(from_vertex),
                        {FeatureKind::corner, k, edge.from});
                }
            }
            // [touching.vertex-on-corner]
            if (at_start || at_end || along < -pair.tolerance || along > edge.length + pair.tolerance) continue;
            add(pair, r_a, -(pair.world_from_b.rotation * edge.normal), gap, {FeatureKind::vertex_of_a, k, edge.from});
        }
    }
}

void touch(const Pair& pair, const Polygon& a, const Polygon& b)
{
    touch_vertices(pair, a, b, true);
    const std::size_t first = pair.touches.size();
    const Pair seen_from_b{pair.world_from_b, pair.world_from_a, -pair.b_to_a, pair.tolerance, pair.touches};
    touch_vertices(seen_from_b, b, a, false);
    mirror(pair.touches, first);
}

template <typename A, typename B>
concept Ordered = requires(const Pair& pair, const A& a, const B& b) { touch(pair, a, b); };

} // namespace

void find_touches(const Shape& a, const Pose& world_from_a, const Shape& b, const Pose& world_from_b, double tolerance,
                  std::vector<Touch>& touches)
{
    touches.clear();
    const Vec2 b_to_a = world_from_a.position - world_from_b.position;
    const auto visit = [&](const auto& shape_a, const auto& shape_b) {
        using A = std::decay_t<decltype(shape_a)>;
        using B = std::decay_t<decltype(shape_b)>;
        if constexpr (Ordered<A, B>) {
            touch(Pair{world_from_a, world_from_b, b_to_a, tolerance, touches}, shape_a, shape_b);
        } else if constexpr (Ordered<B, A>) {
            touch(Pair{world_from_b, world_from_a, -b_to_a, tolerance, touches}, shape_b, shape_a);
            mirror(touches, 0);
        }
    };
    std::visit(visit, a, b);
}

} // namespace flying
