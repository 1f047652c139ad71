#include "draw/body_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace flying {

namespace {

constexpr double k_far = 30000.0; ///< farther out than any surface reaches [pixels]

using Ring = std::vector<Vec2>;

/// The part of a ring on the side sign * coordinate <= k_far (Sutherland and Hodgman, 1974). Parts that fall apart stay
/// joined along the cut, which lies out of sight.
Ring cut(const Ring& ring, int axis, double sign)
{
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2& from = ring[i];
        const Vec2& to = ring[(i + 1) % ring.size()];
        const double from_over = sign * from[axis] - k_far;
        const double to_over = sign * to[axis] - k_far;
        if (from_over <= 0.0) kept.push_back(from);
        if ((from_over <= 0.0) != (to_over <= 0.0)) {
            const double share = from_over / (from_over - to_over);
            kept.push_back(from + share * (to - from));
        }
    }
    return kept;
}

void add_ring(cairo_t* cairo, const Ring& ring)
{
    cairo_new_sub_path(cairo);
    for (const Vec2& point : ring) cairo_line_to(cairo, point.x(), point.y());
    cairo_close_path(cairo);
}

/// As `add_ring`, cut to where Cairo can draw.
void add_cut_ring(cairo_t* cairo, Ring ring)
{
    for (const int axis : {0, 1}) {
        for (const double sign : {1.0, -1.0}) ring = cut(ring, axis, sign);
    }
    add_ring(cairo, ring);
}

bool is_far(const Ring& ring)
{
    return std::any_of(ring.begin(), ring.end(), [](const Vec2& p) { return p.cwiseAbs().maxCoeff() > k_far; });
}

OutlineKind add_disc(cairo_t* cairo, const Vec2& centre, double radius, double inset)
{
    if (radius + centre.cwiseAbs().maxCoeff() < k_far) {
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, centre.x(), centre.y(), radius - inset, 0.0, 2.0 * std::numbers::pi);
        cairo_close_path(cairo);
        return OutlineKind::by_inset;
    }
    constexpr int k_sides = 8192;
    Ring ring;
    for (int i = 0; i < k_sides; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / k_sides;
        ring.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    add_cut_ring(cairo, std::move(ring));
    return OutlineKind::by_stroke;
}

/// The convex polygon whose edges lie `inset` inside those of `polygon`, in the polygon's frame; empty where none is
/// left.
Ring inset_ring(const Polygon& polygon, double inset)
{
    Ring ring;
    const auto edges = polygon.edges();
    const auto vertices = polygon.vertices();
    for (int k = 0; k < static_cast<int>(vertices.size()); ++k) {
        const Vec2& normal = edges[k].normal;
        const Vec2& normal_before = edges[polygon.previous(k)].normal;
        const double stretch = 1.0 + normal.dot(normal_before);
        if (stretch < 1e-3) return {};
        ring.push_back(vertices[k] - inset / stretch * (normal + normal_before));
    }
    // An edge that turned round has passed the opposite side
    for (const Edge& edge : edges) {
        if (edge.tangent.dot(ring[edge.to] - ring[edge.from]) <= 0.0) return {};
    }
    return ring;
}

OutlineKind add_polygon(cairo_t* cairo, const DrawnBody& body, const Polygon& polygon, const ViewMap& map, double inset)
{
    if (inset > 0.0) {
        Ring ring = inset_ring(polygon, inset / map.scale);
        if (ring.empty()) return OutlineKind::too_thin;
        for (Vec2& point : ring) point = map(body.pose * point);
        add_ring(cairo, ring);
        return OutlineKind::by_inset;
    }
    bool was_cut = false;
    const auto starts = polygon.ring_starts();
    for (std::size_t r = 0; r + 1 < starts.size(); ++r) {
        Ring ring;
        for (int k = starts[r]; k < starts[r + 1]; ++k) ring.push_back(map(body.pose * polygon.vertices()[k]));
        if (is_far(ring)) {
            was_cut = true;
            add_cut_ring(cairo, std::move(ring));
        } else {
            add_ring(cairo, ring);
        }
    }
    return polygon.is_convex() && !was_cut ? OutlineKind::by_inset : OutlineKind::by_stroke;
}

} // namespace

OutlineKind add_body_path(cairo_t* cairo, const DrawnBody& body, const ViewMap& map, double inset)
{
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_EVEN_ODD);
    if (const auto* disc = std::get_if<Disc>(&body.shape)) {
        return add_disc(cairo, map(body.pose.position), disc->radius * map.scale, inset);
    }
    if (const auto* polygon = std::get_if<Polygon>(&body.shape)) {
        return add_polygon(cairo, body, *polygon, map, inset);
    }
    return OutlineKind::by_inset;
}

} // namespace flying
