#include "geometry/moments.hpp"

#include "math/twofold.hpp"

namespace flying {

namespace {

/// From the common corner of all triangles to a vertex, without loss.  [m]
struct Arm
{
    Twofold x;
    Twofold y;
};

Arm arm(const Vec2& corner, const Vec2& vertex)
{
    return {two_sum(vertex.x(), -corner.x()), two_sum(vertex.y(), -corner.y())};
}

/// What signed triangles add up to, about their common corner.
struct Sums
{
    Twofold twice_area; ///< sum of a x b [m^2]
    Twofold first_x;    ///< sum of (a x b) (a + b): six areas times the centroid [m^3]
    Twofold first_y;
    Twofold second;     ///< sum of (a x b) (a.a + a.b + b.b): twelve second moments [m^4]
};

/// Adds the triangle of the corner and one edge; a and b are the arms to the edge's ends.
void add_triangle(Sums& sums, const Arm& a, const Arm& b)
{
    const Twofold twice_area = a.x * b.y - a.y * b.x;
    const Twofold aa = a.x * a.x + a.y * a.y;
    const Twofold ab = a.x * b.x + a.y * b.y;
    const Twofold bb = b.x * b.x + b.y * b.y;
    sums.twice_area = sums.twice_area + twice_area;
    sums.first_x = sums.first_x + twice_area * (a.x + b.x);
    sums.first_y = sums.first_y + twice_area * (a.y + b.y);
    sums.second = sums.second + twice_area * ((aa + ab) + bb);
}

/// Adds the triangles of all edges of a ring.
void add_ring(Sums& sums, const Vec2& corner, std::span<const Vec2> ring)
{
    Arm a = arm(corner, ring.back());
    for (const Vec2& vertex : ring) {
        const Arm b = arm(corner, vertex);
        add_triangle(sums, a, b);
        a = b;
    }
}

/// Area and centroid from the sums, and the second moment about it (parallel axes).
AreaMoments about_centroid(const Sums& sums, const Vec2& corner)
{
    if (sums.twice_area.upper == 0.0) return {0.0, corner, 0.0};

    const Twofold area = Twofold(0.5) * sums.twice_area;
    const Twofold six_areas = Twofold(6.0) * area;
    const Twofold x = sums.first_x / six_areas;
    const Twofold y = sums.first_y / six_areas;
    const Twofold second = sums.second / Twofold(12.0) - area * (x * x + y * y);
    const Twofold from_origin_x = Twofold(corner.x()) + x;
    const Twofold from_origin_y = Twofold(corner.y()) + y;
    return {area.rounded(), Vec2(from_origin_x.rounded(), from_origin_y.rounded()),
            second.rounded()};
}

} // namespace

AreaMoments moments_of_ring(std::span<const Vec2> ring)
{
    const Vec2 corner = ring.front();
    Sums sums;
    add_ring(sums, corner, ring);
    return about_centroid(sums, corner);
}

AreaMoments moments_of(const Polygon& polygon)
{
    const std::span<const Vec2> vertices = polygon.vertices();
    const std::span<const int> starts = polygon.ring_starts();
    const Vec2 corner = vertices.front();

    // Holes turn the other way: their triangles take away what the outer ring has counted
    Sums sums;
    for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
        add_ring(sums, corner, vertices.subspan(starts[k], starts[k + 1] - starts[k]));
    }
    return about_centroid(sums, corner);
}

} // namespace flying
