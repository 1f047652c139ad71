#include "geometry/make_polygon.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "geometry/moments.hpp"
#include "geometry/ring_checks.hpp"
#include "math/tolerance.hpp"

namespace flying {

namespace {

GivenRing given_ring(std::string place, std::span<const Vec2> points)
{
    GivenRing ring;
    ring.place = std::move(place);
    ring.points.assign(points.begin(), points.end());
    for (std::size_t k = 0; k < points.size(); ++k) ring.indices.push_back(static_cast<int>(k));
    return ring;
}

std::vector<GivenRing> given_rings(std::span<const Vec2> outer, std::span<const std::vector<Vec2>> holes)
{
    std::vector<GivenRing> rings{given_ring("vertices", outer)};
    for (std::size_t k = 0; k < holes.size(); ++k) {
        rings.push_back(given_ring("holes[" + std::to_string(k) + "]", holes[k]));
    }
    return rings;
}

Faults check(std::vector<GivenRing>& rings)
{
    Faults faults;
    for (GivenRing& ring : rings) check_numbers(ring, faults);

    // The outer ring's size decides which vertices count as one, in holes too
    const double size = check_size(rings.front(), faults);
    for (std::size_t k = 1; k < rings.size(); ++k) check_size(rings[k], faults);
    for (GivenRing& ring : rings) check_count(ring, tolerance::k_shortest_edge * size, faults);

    for (const GivenRing& ring : rings) check_area(ring, faults);
    check_edges(rings, faults);
    check_nesting(rings, faults);
    return faults;
}

/// Outer ring counter-clockwise, holes clockwise; the first vertex stays the first.
void wind(std::vector<GivenRing>& rings)
{
    for (std::size_t k = 0; k < rings.size(); ++k) {
        std::vector<Vec2>& points = rings[k].points;
        const bool is_counter_clockwise = moments_of_ring(points).area > 0.0;
        const bool is_outer = k == 0;
        if (is_counter_clockwise == is_outer) continue;
        std::reverse(points.begin() + 1, points.end());
        std::reverse(rings[k].indices.begin() + 1, rings[k].indices.end());
    }
}

void move_all(std::vector<GivenRing>& rings, const Vec2& offset)
{
    for (GivenRing& ring : rings) {
        for (Vec2& point : ring.points) point += offset;
    }
}

Polygon polygon_of(const std::vector<GivenRing>& rings)
{
    std::vector<std::vector<Vec2>> points;
    points.reserve(rings.size());
    for (const GivenRing& ring : rings) points.push_back(ring.points);
    return Polygon(points);
}

/// Moves the rings to their centroid. First a vertex becomes the origin, then the centroid: seen from near by, it is
/// known to an error of the polygon's size, and not of its distance from where it was given.
CentredPolygon centred(std::vector<GivenRing>& rings)
{
    const Vec2 centroid = moments_of(polygon_of(rings)).centroid;
    const Vec2 corner = rings.front().points.front();
    move_all(rings, -corner);
    const Vec2 from_corner = moments_of(polygon_of(rings)).centroid;
    move_all(rings, -from_corner);
    return {polygon_of(rings), centroid};
}

} // namespace

Expected<CentredPolygon> make_polygon(std::span<const Vec2> outer, std::span<const std::vector<Vec2>> holes)
{
    std::vector<GivenRing> rings = given_rings(outer, holes);
    const Faults faults = check(rings);
    if (!faults.empty()) return faults;

    wind(rings);
    CentredPolygon made = centred(rings);

    // What was apart by less than a rounding may meet now
    Faults after;
    check_edges(rings, after);
    for (Fault& fault : after) {
        fault.found += ", once the polygon is moved to its centroid";
        fault.expected = "edges that are further apart than rounding";
    }
    if (!after.empty()) return after;
    return made;
}

} // namespace flying
