#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/polygon.hpp"
#include "math/random.hpp"
#include "math/rotation.hpp"

/// Polygons and oracles that tests of several folders share.
namespace flying::testing {

inline Polygon box(double width, double height)
{
    const double x = 0.5 * width;
    const double y = 0.5 * height;
    return Polygon({{Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)}});
}

inline Pose at(double x, double y, double angle = 0.0)
{
    return {Vec2(x, y), Rotation::of(angle)};
}

/// Vertices on a circle in random places, counter-clockwise: convex by construction.
inline Polygon random_convex(Random& random, int most_sides = 9)
{
    const int count = 3 + random.below(most_sides - 2);
    std::vector<double> angles;
    for (int k = 0; k < count; ++k) angles.push_back((k + 0.9 * random.uniform()) * 2.0 * std::numbers::pi / count);
    const double radius = random.uniform(0.3, 1.5);
    const Vec2 middle{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)};
    std::vector<Vec2> ring;
    for (const double angle : angles) ring.push_back(middle + radius * Vec2(std::cos(angle), std::sin(angle)));
    return Polygon({ring});
}

/// Star-shaped about the origin, mostly not convex; every second time with vertices in the middle of some edges; with a
/// hole of the same kind where `has_hole`.
inline Polygon random_star(Random& random, bool has_hole, int most_sides = 12)
{
    const auto ring_of = [&](double least, double greatest) {
        const int count = 5 + random.below(most_sides - 4);
        std::vector<Vec2> ring;
        for (int k = 0; k < count; ++k) {
            const double angle = (k + 0.7 * random.uniform()) * 2.0 * std::numbers::pi / count;
            ring.push_back(random.uniform(least, greatest) * Vec2(std::cos(angle), std::sin(angle)));
        }
        return ring;
    };
    std::vector<std::vector<Vec2>> rings = {ring_of(0.5, 1.5)};
    if (random.below(2) == 0) {
        std::vector<Vec2> with_middles;
        for (std::size_t k = 0; k < rings[0].size(); ++k) {
            with_middles.push_back(rings[0][k]);
            const Vec2 middle = 0.5 * (rings[0][k] + rings[0][(k + 1) % rings[0].size()]);
            if (random.below(2) == 0) with_middles.push_back(middle);
        }
        rings[0] = with_middles;
    }
    if (has_hole) {
        // The outer ring comes no nearer than 0.5 cos(2 pi 1.7 / 10) to the origin, where it has five vertices
        std::vector<Vec2> hole = ring_of(0.08, 0.2);
        std::reverse(hole.begin(), hole.end());
        rings.push_back(hole);
    }
    return Polygon(rings);
}

inline Pose random_pose(Random& random, double reach)
{
    const double x = random.uniform(-reach, reach);
    const double y = random.uniform(-reach, reach);
    return {Vec2(x, y), Rotation::of(random.uniform(-4.0, 4.0))};
}

/// The polygon's ring k, placed.
inline std::vector<Vec2> placed_ring(const Polygon& polygon, const Pose& pose, int k = 0)
{
    std::vector<Vec2> ring;
    for (int v = polygon.ring_starts()[k]; v < polygon.ring_starts()[k + 1]; ++v) {
        ring.push_back(pose * polygon.vertices()[v]);
    }
    return ring;
}

/// Signed area, by the trapezoids under the edges.
inline double area_of_polygon(const Polygon& polygon)
{
    long double twice = 0.0L;
    for (const Edge& edge : polygon.edges()) {
        const Vec2& p = polygon.vertices()[edge.from];
        const Vec2& q = polygon.vertices()[edge.to];
        twice += static_cast<long double>(p.x()) * q.y() - static_cast<long double>(q.x()) * p.y();
    }
    return static_cast<double>(0.5L * twice);
}

/// The point lies inside, by counting the edges that a ray to the right meets.
inline bool contains(const Polygon& polygon, const Pose& pose, const Vec2& point)
{
    const Vec2 local = inverse(pose.rotation) * Vec2(point - pose.position);
    bool inside = false;
    for (const Edge& edge : polygon.edges()) {
        const Vec2& p = polygon.vertices()[edge.from];
        const Vec2& q = polygon.vertices()[edge.to];
        if ((p.y() > local.y()) == (q.y() > local.y())) continue;
        const double x = p.x() + (local.y() - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
        if (x > local.x()) inside = !inside;
    }
    return inside;
}

/// Distance of a point from a segment.
inline double point_to_segment(const Vec2& point, const Vec2& p, const Vec2& q)
{
    const double part = std::clamp((point - p).dot(q - p) / (q - p).squaredNorm(), 0.0, 1.0);
    return (point - (p + part * (q - p))).norm();
}

/// Least distance between the boundaries of two polygons that don't cross: every vertex against every edge.
inline double boundary_distance(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b)
{
    double least = 1e300;
    const auto one_way = [&](const Polygon& p, const Pose& pose_p, const Polygon& q, const Pose& pose_q) {
        for (const Vec2& vertex : p.vertices()) {
            for (const Edge& edge : q.edges()) {
                const Vec2 from = pose_q * q.vertices()[edge.from];
                const Vec2 to = pose_q * q.vertices()[edge.to];
                least = std::min(least, point_to_segment(pose_p * vertex, from, to));
            }
        }
    };
    one_way(a, pose_a, b, pose_b);
    one_way(b, pose_b, a, pose_a);
    return least;
}

/// Two boundaries cross properly.
inline bool boundaries_cross(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b)
{
    for (const Edge& e : a.edges()) {
        const Vec2 p = pose_a * a.vertices()[e.from];
        const Vec2 q = pose_a * a.vertices()[e.to];
        for (const Edge& f : b.edges()) {
            const Vec2 u = pose_b * b.vertices()[f.from];
            const Vec2 v = pose_b * b.vertices()[f.to];
            const bool parts_uv = cross(q - p, u - p) * cross(q - p, v - p) < 0.0;
            const bool parts_pq = cross(v - u, p - u) * cross(v - u, q - u) < 0.0;
            if (parts_uv && parts_pq) return true;
        }
    }
    return false;
}

/// Signed distance of the origin from the set of all differences b - a of points of two convex polygons: the distance
/// where it lies outside, minus the shortest way out where it lies inside. That is the separation of A and B, found
/// without a look at any edge's normal. The hull is that of all differences of vertices (Andrew's monotone chain).
inline double minkowski_separation(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b)
{
    std::vector<Vec2> points;
    for (const Vec2& p : a.vertices()) {
        for (const Vec2& q : b.vertices()) points.push_back(pose_b * q - pose_a * p);
    }
    std::sort(points.begin(), points.end(),
              [](const Vec2& p, const Vec2& q) { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); });
    std::vector<Vec2> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t base = hull.size();
        for (const Vec2& p : points) {
            while (hull.size() >= base + 2) {
                const Vec2& last = hull.back();
                const Vec2& before = hull[hull.size() - 2];
                if (cross(last - before, p - last) > 0.0) break;
                hull.pop_back();
            }
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    double outside = -1e300;
    double distance = 1e300;
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const Vec2& p = hull[k];
        const Vec2& q = hull[(k + 1) % hull.size()];
        outside = std::max(outside, -cross(q - p, -p) / (q - p).norm());
        distance = std::min(distance, point_to_segment(Vec2::Zero(), p, q));
    }
    return outside > 0.0 ? distance : outside;
}

} // namespace flying::testing
