#include "geometry/straight_vertices.hpp"

#include <cmath>
#include <vector>

#include "math/tolerance.hpp"

namespace flying {

namespace {

/// `between` stands on the way from one point to another, off the line between them by rounding alone.
///
/// reach  greatest distance of the points from the origin of their frame, which decides how coarse rounding is [m]
bool is_straight_between(const Vec2& from, const Vec2& between, const Vec2& to, double reach)
{
    const Vec2 way = to - from;
    const Vec2 part = between - from;
    const double along = way.dot(part);
    const double square = way.squaredNorm();
    if (!(along > 0.0 && along < square)) return false;
    return std::abs(cross(way, part)) <= tolerance::coordinate_rounding(reach) * std::sqrt(square);
}

/// A vertex that is certainly a corner: the one furthest from the origin. Between two others on a line none is.
int furthest_vertex(const Polygon& polygon)
{
    int furthest = 0;
    for (int v = 1; v < static_cast<int>(polygon.vertices().size()); ++v) {
        if (polygon.vertices()[v].squaredNorm() > polygon.vertices()[furthest].squaredNorm()) furthest = v;
    }
    return furthest;
}

} // namespace

Polygon without_straight_vertices(const Polygon& polygon)
{
    const auto vertices = polygon.vertices();
    const int count = static_cast<int>(vertices.size());
    std::vector<char> is_corner(vertices.size(), 1);

    // Walk once round from a corner; what was left out since the last corner must stay on the line to the next vertex
    const int start = furthest_vertex(polygon);
    int last = 0; // steps from the start to the last corner
    bool any = false;
    for (int k = 1; k < count; ++k) {
        const Vec2& from = vertices[(start + last) % count];
        const Vec2& to = vertices[(start + k + 1) % count];
        bool straight = true;
        for (int j = last + 1; j <= k && straight; ++j) {
            straight = is_straight_between(from, vertices[(start + j) % count], to, polygon.radius());
        }
        if (!straight) {
            last = k;
            continue;
        }
        is_corner[(start + k) % count] = 0;
        any = true;
    }
    if (!any) return polygon;

    std::vector<Vec2> corners;
    for (int v = 0; v < count; ++v) {
        if (is_corner[v]) corners.push_back(vertices[v]);
    }
    return Polygon({corners});
}

bool has_straight_side(const Polygon& polygon, const Vec2& from, const Vec2& to)
{
    const auto vertices = polygon.vertices();
    for (const Edge& edge : polygon.edges()) {
        if (vertices[edge.from] != from) continue;
        int v = edge.to;
        while (vertices[v] != to && is_straight_between(from, vertices[v], to, polygon.radius())) v = polygon.edges()[v].to;
        if (vertices[v] == to) return true;
    }
    return false;
}

} // namespace flying
