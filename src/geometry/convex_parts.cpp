#include "geometry/convex_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <utility>

#include "math/orientation.hpp"
#include "math/tolerance.hpp"

namespace flying {

namespace {

/// A ring of vertices as indices into the polygon's. A vertex at which a bridge ends stands in its ring twice.
using Ring = std::vector<int>;

/// c lies strictly between a and b; the three stand on one line.
bool between(const Vec2& a, const Vec2& b, const Vec2& c)
{
    if (a.x() != b.x()) return std::min(a.x(), b.x()) < c.x() && c.x() < std::max(a.x(), b.x());
    return std::min(a.y(), b.y()) < c.y() && c.y() < std::max(a.y(), b.y());
}

/// The segments a-b and c-d share a point that is not an end of both.
bool block_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const int c_side = orientation(a, b, c);
    const int d_side = orientation(a, b, d);
    const int a_side = orientation(c, d, a);
    const int b_side = orientation(c, d, b);
    if (c_side * d_side < 0 && a_side * b_side < 0) return true;

    // An end within the other segment blocks too
    if (c_side == 0 && between(a, b, c)) return true;
    if (d_side == 0 && between(a, b, d)) return true;
    if (a_side == 0 && between(c, d, a)) return true;
    return b_side == 0 && between(c, d, b);
}

/// At the corner previous -> corner -> next of a ring, `target` lies towards the inside.
bool looks_inside(const Vec2& previous, const Vec2& corner, const Vec2& next, const Vec2& target)
{
    const bool left_of_first = orientation(previous, corner, target) > 0;
    const bool left_of_second = orientation(corner, next, target) > 0;
    const bool reflex = orientation(previous, corner, next) < 0;
    return reflex ? left_of_first || left_of_second : left_of_first && left_of_second;
}

/// The place in `ring` from which a bridge to vertex `to` meets no edge. There always is one where `to` is the
/// rightmost vertex of all rings that are not joined yet.
std::size_t bridge_head(std::span<const Vec2> vertices, std::span<const Edge> edges, const Ring& ring, int to)
{
    // Try near places first: short bridges make better parts
    std::vector<std::size_t> places(ring.size());
    for (std::size_t k = 0; k < ring.size(); ++k) places[k] = k;
    std::stable_sort(places.begin(), places.end(), [&](std::size_t j, std::size_t k) {
        return (vertices[ring[j]] - vertices[to]).squaredNorm() < (vertices[ring[k]] - vertices[to]).squaredNorm();
    });

    for (const std::size_t place : places) {
        const Vec2& corner = vertices[ring[place]];
        const Vec2& previous = vertices[ring[(place + ring.size() - 1) % ring.size()]];
        const Vec2& next = vertices[ring[(place + 1) % ring.size()]];
        if (!looks_inside(previous, corner, next, vertices[to])) continue;

        // Neither the polygon's edges nor earlier bridges may stand in the way
        bool free = std::none_of(edges.begin(), edges.end(), [&](const Edge& edge) {
            return block_each_other(corner, vertices[to], vertices[edge.from], vertices[edge.to]);
        });
        for (std::size_t k = 0; free && k < ring.size(); ++k) {
            free = !block_each_other(corner, vertices[to], vertices[ring[k]], vertices[ring[(k + 1) % ring.size()]]);
        }
        if (free) return place;
    }
    return 0; // no such place: the rings were no polygon
}

/// One ring that goes round all of the polygon, its holes joined by bridges there and back.
Ring joined_ring(const Polygon& polygon)
{
    const std::span<const Vec2> vertices = polygon.vertices();
    const std::span<const int> starts = polygon.ring_starts();
    Ring ring;
    for (int v = 0; v < starts[1]; ++v) ring.push_back(v);

    // Find the rightmost vertex of every hole, and join the holes from right to left
    std::vector<std::pair<int, std::size_t>> holes;
    for (std::size_t k = 1; k + 1 < starts.size(); ++k) {
        int rightmost = starts[k];
        for (int v = starts[k]; v < starts[k + 1]; ++v) {
            if (vertices[v].x() > vertices[rightmost].x()) rightmost = v;
        }
        holes.emplace_back(rightmost, k);
    }
    std::stable_sort(holes.begin(), holes.end(),
                     [&](const auto& g, const auto& h) { return vertices[g.first].x() > vertices[h.first].x(); });

    for (const auto& [rightmost, k] : holes) {
        const std::size_t place = bridge_head(vertices, polygon.edges(), ring, rightmost);

        // Over the bridge, once round the hole, and back to where the bridge began
        Ring tour;
        const int count = starts[k + 1] - starts[k];
        for (int step = 0; step <= count; ++step) {
            tour.push_back(starts[k] + (rightmost - starts[k] + step) % count);
        }
        tour.push_back(ring[place]);
        ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(place) + 1, tour.begin(), tour.end());
    }
    return ring;
}

/// The sign of the turn; 0 also where c is no further from the line of a and b than `room` [m].
int turn_beyond(const Vec2& a, const Vec2& b, const Vec2& c, double room)
{
    if (std::abs(cross(b - a, c - a)) <= room * (b - a).norm()) return 0;
    return orientation(a, b, c);
}

/// The triangle before, at and after a place of the ring can be cut off: it turns left and holds no other vertex.
///
/// room  so near to a side of the triangle a vertex counts as on it [m]
bool is_ear(std::span<const Vec2> vertices, const Ring& ring, std::size_t place, double room)
{
    const Vec2& a = vertices[ring[(place + ring.size() - 1) % ring.size()]];
    const Vec2& b = vertices[ring[place]];
    const Vec2& c = vertices[ring[(place + 1) % ring.size()]];
    if (turn_beyond(a, b, c, room) <= 0 || turn_beyond(b, c, a, room) <= 0 || turn_beyond(c, a, b, room) <= 0)
        return false;

    // Look first at the box round the triangle, which is cheap
    const Vec2 low = a.cwiseMin(b).cwiseMin(c) - Vec2(room, room);
    const Vec2 high = a.cwiseMax(b).cwiseMax(c) + Vec2(room, room);
    for (const int v : ring) {
        const Vec2& p = vertices[v];
        if (p.x() < low.x() || p.x() > high.x() || p.y() < low.y() || p.y() > high.y()) continue;
        if (p == a || p == b || p == c) continue;
        if (turn_beyond(a, b, p, room) >= 0 && turn_beyond(b, c, p, room) >= 0 && turn_beyond(c, a, p, room) >= 0)
            return false;
    }
    return true;
}

/// The inside of a ring as triangles, each turning counter-clockwise. As long as there is any that no vertex comes
/// near, such a one is cut off: of vertices that stand on one line but for rounding others would leave slivers.
std::vector<Ring> triangles_of(std::span<const Vec2> vertices, Ring ring, double rounding)
{
    std::vector<Ring> triangles;
    std::size_t place = 0;
    std::size_t failures = 0;
    while (ring.size() >= 3) {
        place %= ring.size();
        const double room = failures > ring.size() ? 0.0 : rounding;
        const bool stuck = failures > 2 * ring.size() + 1; // happens to no polygon, but must not hang
        if (!stuck && !is_ear(vertices, ring, place, room)) {
            ++place;
            ++failures;
            continue;
        }
        const int a = ring[(place + ring.size() - 1) % ring.size()];
        const int b = ring[place];
        const int c = ring[(place + 1) % ring.size()];
        if (orientation(vertices[a], vertices[b], vertices[c]) > 0) triangles.push_back({a, b, c});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(place));
        failures = 0;
    }
    return triangles;
}

/// [sine] A side and a cut that turn by less at their common vertex stand in one line. Twice what the contacts of
/// resting bodies once allowed two normals to differ by.
constexpr double k_in_line = 0x1p-9;

/// At the vertex `at` of a ring a side of the polygon and a cut follow each other in one line.
bool mixes_side_and_cut(const Polygon& polygon, int before, int at, int after)
{
    const bool comes_along_side = polygon.edges()[before].to == at;
    const bool goes_along_side = polygon.edges()[at].to == after;
    if (comes_along_side == goes_along_side) return false;
    const Vec2 in = polygon.vertices()[at] - polygon.vertices()[before];
    const Vec2 out = polygon.vertices()[after] - polygon.vertices()[at];
    return in.dot(out) > 0.0 && std::abs(cross(in, out)) <= k_in_line * in.norm() * out.norm();
}

/// Two convex rings that share the edge i -> j of the first as one ring; empty where that would not be convex, or would
/// put a side and a cut in one line.
Ring merged(const Polygon& polygon, const Ring& first, const Ring& second, int i, int j)
{
    // Walk the first from j round to i, then the second from behind i to before j
    Ring ring = first;
    std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), j), ring.end());
    Ring rest = second;
    std::rotate(rest.begin(), std::find(rest.begin(), rest.end(), i), rest.end());
    ring.insert(ring.end(), rest.begin() + 1, rest.end() - 1);

    // The boundary may have become reflex at the ends of the edge, and nowhere else
    const std::size_t count = ring.size();
    for (std::size_t k = 0; k < count; ++k) {
        if (ring[k] != i && ring[k] != j) continue;
        const int before = ring[(k + count - 1) % count];
        const int after = ring[(k + 1) % count];
        const std::span<const Vec2> vertices = polygon.vertices();
        if (orientation(vertices[before], vertices[ring[k]], vertices[after]) < 0) return {};
        if (mixes_side_and_cut(polygon, before, ring[k], after)) return {};
    }
    return ring;
}

/// Take away every shared edge whose parts may be one without it, in the order of the triangles.
void merge_convex(const Polygon& polygon, std::vector<Ring>& parts)
{
    std::map<std::pair<int, int>, std::size_t> part_at; // left of the edge from the first vertex to the second
    std::vector<std::pair<int, int>> directed;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        for (std::size_t k = 0; k < 3; ++k) {
            directed.emplace_back(parts[part][k], parts[part][(k + 1) % 3]);
            part_at[directed.back()] = part;
        }
    }

    for (const auto& [i, j] : directed) {
        const auto left = part_at.find({i, j});
        const auto right = part_at.find({j, i});
        if (left == part_at.end() || right == part_at.end()) continue;
        const std::size_t keep = left->second;
        const std::size_t lose = right->second;
        Ring both = merged(polygon, parts[keep], parts[lose], i, j);
        if (both.empty()) continue;

        const Ring& lost = parts[lose];
        for (std::size_t k = 0; k < lost.size(); ++k) part_at[{lost[k], lost[(k + 1) % lost.size()]}] = keep;
        part_at.erase({i, j});
        part_at.erase({j, i});
        parts[lose].clear();
        parts[keep] = std::move(both);
    }
    std::erase_if(parts, [](const Ring& part) { return part.empty(); });
}

} // namespace

std::vector<Polygon> convex_parts(const Polygon& polygon)
{
    if (polygon.is_convex()) return {polygon};

    const std::span<const Vec2> vertices = polygon.vertices();
    std::vector<Ring> rings =
        triangles_of(vertices, joined_ring(polygon), tolerance::coordinate_rounding(polygon.radius()));
    merge_convex(polygon, rings);

    std::vector<Polygon> parts;
    for (const Ring& ring : rings) {
        std::vector<Vec2> corners;
        for (const int v : ring) corners.push_back(vertices[v]);
        parts.emplace_back(std::vector<std::vector<Vec2>>{corners});
    }
    return parts;
}

} // namespace flying
