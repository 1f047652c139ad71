#include "geometry/ring_checks.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/meeting_edges.hpp"
#include "geometry/moments.hpp"
#include "math/number_text.hpp"
#include "math/orientation.hpp"
#include "math/tolerance.hpp"

namespace flying {

namespace {

std::string text_of(const Vec2& a)
{
    return "(" + number_text(a.x()) + ", " + number_text(a.y()) + ")";
}

/// The longer side of the smallest box about the points.  [m]
double extent(std::span<const Vec2> points)
{
    Vec2 low = points.front();
    Vec2 high = points.front();
    for (const Vec2& point : points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    return std::max(high.x() - low.x(), high.y() - low.y());
}

bool in_range(double x)
{
    const double size = std::abs(x);
    return size == 0.0 || (size >= tolerance::k_least_coordinate && size <= tolerance::k_greatest_coordinate);
}

std::vector<GivenEdge> edges_of(std::span<const GivenRing> rings)
{
    std::vector<GivenEdge> edges;
    for (std::size_t r = 0; r < rings.size(); ++r) {
        if (!rings[r].is_checkable) continue;
        const std::vector<Vec2>& points = rings[r].points;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const std::size_t next = (k + 1) % points.size();
            edges.push_back({r, k, next, points[k], points[next]});
        }
    }
    return edges;
}

std::string text_of(const GivenEdge& edge, std::span<const GivenRing> rings)
{
    const GivenRing& ring = rings[edge.ring];
    return "edge " + std::to_string(ring.indices[edge.from]) + " of " + ring.place + ", from " + text_of(edge.a) +
           " to " + text_of(edge.b);
}

/// Whether the point lies inside the ring; it is not on the ring's boundary. Counts how often the ring winds about it.
bool is_inside(const Vec2& point, const std::vector<Vec2>& ring)
{
    int turns = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2& a = ring[k];
        const Vec2& b = ring[(k + 1) % ring.size()];
        const bool a_below = a.y() <= point.y();
        const bool b_below = b.y() <= point.y();
        if (a_below && !b_below && orientation(a, b, point) > 0) ++turns;
        if (!a_below && b_below && orientation(a, b, point) < 0) --turns;
    }
    return turns != 0;
}

} // namespace

std::string place_of(const GivenRing& ring, std::size_t k)
{
    return ring.place + "[" + std::to_string(ring.indices[k]) + "]";
}

void check_numbers(GivenRing& ring, Faults& faults)
{
    for (std::size_t k = 0; k < ring.points.size(); ++k) {
        const Vec2& point = ring.points[k];
        if (in_range(point.x()) && in_range(point.y())) continue;
        ring.is_checkable = false;
        faults.push_back({place_of(ring, k), text_of(point),
                          is_finite(point)
                              ? "coordinates that are 0, or between " + number_text(tolerance::k_least_coordinate) +
                                    " and " + number_text(tolerance::k_greatest_coordinate) + " in size"
                              : "finite coordinates"});
    }
}

double check_size(GivenRing& ring, Faults& faults)
{
    if (!ring.is_checkable || ring.points.empty()) return 0.0;
    const double size = extent(ring.points);
    if (size == 0.0 || size >= tolerance::k_least_size) return size;
    ring.is_checkable = false;
    faults.push_back(
        {ring.place, "a size of " + number_text(size), "a size of " + number_text(tolerance::k_least_size) + " or more"});
    return size;
}

void check_count(GivenRing& ring, double distance, Faults& faults)
{
    if (!ring.is_checkable) return;
    const std::size_t given = ring.points.size();

    // Keep each vertex that is away from the last one kept
    const auto is_repeated = [&](const Vec2& a, const Vec2& b) { return (a - b).norm() <= distance; };
    std::size_t kept = 0;
    for (std::size_t k = 0; k < given; ++k) {
        if (kept > 0 && is_repeated(ring.points[k], ring.points[kept - 1])) continue;
        ring.points[kept] = ring.points[k];
        ring.indices[kept] = ring.indices[k];
        ++kept;
    }
    while (kept > 1 && is_repeated(ring.points[kept - 1], ring.points[0])) --kept;
    ring.points.resize(kept);
    ring.indices.resize(kept);
    if (kept >= 3) return;

    ring.is_checkable = false;
    const std::string distinct = kept == given ? "" : ", " + std::to_string(kept) + " of them distinct";
    faults.push_back({ring.place, std::to_string(given) + (given == 1 ? " vertex" : " vertices") + distinct,
                      "three distinct vertices or more"});
}

void check_edges(std::span<GivenRing> rings, Faults& faults)
{
    const std::vector<GivenEdge> edges = edges_of(rings);
    const std::vector<Partner> partners = meeting_edges(edges);
    for (std::size_t k = 0; k < edges.size(); ++k) {
        const Partner& partner = partners[k];
        if (partner.count == 0) continue;
        const GivenEdge& e = edges[k];
        const GivenEdge& f = edges[partner.edge];
        const std::string verb = partner.meeting == Meeting::cross ? " crosses " : " touches ";
        const std::string more = partner.count == 1 ? "" : ", and meets " + std::to_string(partner.count - 1) + " more";
        faults.push_back({place_of(rings[e.ring], e.from), text_of(e, rings) + verb + text_of(f, rings) + more,
                          "edges that do not cross or touch"});
    }

    // Say which rings are in each other's way: nesting means nothing there
    for (std::size_t k = 0; k < edges.size(); ++k) {
        if (partners[k].count == 0) continue;
        GivenRing& ring = rings[edges[k].ring];
        GivenRing& other = rings[edges[partners[k].edge].ring];
        if (&ring == &other) ring.meets_itself = true;
        if (&ring != &other) ring.meets_another = other.meets_another = true;
    }
}

void check_area(const GivenRing& ring, Faults& faults)
{
    if (!ring.is_checkable) return;
    const double size = extent(ring.points);
    const double area = std::abs(moments_of_ring(ring.points).area);
    const double least = tolerance::k_smallest_area * (size * size);
    if (area >= least) return;
    faults.push_back({ring.place, "an area of " + number_text(area) + " m^2",
                      "an area of at least " + number_text(least) + " m^2 in a ring of this size"});
}

void check_nesting(std::span<const GivenRing> rings, Faults& faults)
{
    const auto has_inside = [](const GivenRing& ring) { return ring.is_checkable && !ring.meets_itself; };
    for (std::size_t k = 1; k < rings.size(); ++k) {
        if (!has_inside(rings[k]) || rings[k].meets_another) continue;
        const Vec2& point = rings[k].points.front();
        if (has_inside(rings[0]) && !is_inside(point, rings[0].points)) {
            faults.push_back({rings[k].place, "a hole outside " + rings[0].place + ", at " + text_of(point),
                              "holes strictly inside"});
        }
        for (std::size_t other = 1; other < rings.size(); ++other) {
            if (other == k || !has_inside(rings[other]) || !is_inside(point, rings[other].points)) continue;
            faults.push_back({rings[k].place, "a hole inside " + rings[other].place + ", at " + text_of(point),
                              "holes outside each other"});
        }
    }
}

} // namespace flying
