#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "collide/contact.hpp"
#include "collide/separating_axis.hpp"
#include "geometry/polygon.hpp"
#include "math/orientation.hpp"
#include "math/rotation.hpp"
#include "math/tolerance.hpp"

namespace flying {

/// Segments a-b and c-d cross: each has its ends strictly on different sides of the other. Exact.
[[nodiscard]] inline bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
}

/// A corner has entered a body over one of its edges: both sides of the corner cross the edge, and the corner lies on
/// its inner side, which is its left. Exact.
///
/// before, corner, after  three vertices of a ring, in order
/// from, to               ends of the other body's edge
[[nodiscard]] inline bool corner_has_entered(const Vec2& before, const Vec2& corner, const Vec2& after,
                                             const Vec2& from, const Vec2& to)
{
    const bool is_inside = orientation(from, to, corner) > 0;
    return is_inside && segments_cross(before, corner, from, to) && segments_cross(corner, after, from, to);
}

namespace vertex_edge {

/// Both polygons in A's frame.
struct Pair
{
    const Polygon* polygon[2];
    std::vector<Vec2> vertices[2];
    std::vector<Vec2> normals[2]; ///< outward, of the edges
    Vec2 push = Vec2::Zero();     ///< the way in which ties are broken: A towards B
    double rounding = 0.0;        ///< of a distance [m]
};

/// A point where the boundaries of the two cross.
struct Crossing
{
    int edge[2] = {0, 0};         ///< of A and of B
    double along[2] = {0.0, 0.0}; ///< 0 at the edge's start, 1 at its end
    Vec2 point = Vec2::Zero();    ///< in A's frame
    bool a_enters = false;        ///< along A one comes into B here; along B, out of A
    bool is_used = false;
};

/// On which side of the line from -> to the point lies, +1 left or -1 right. A point on the
/// line counts as if it were pushed by next to nothing along `push`, and if that leads
/// along the line, to the left of `push`.
inline int side(const Vec2& from, const Vec2& to, const Vec2& point, const Vec2& push)
{
    const int turn = orientation(from, to, point);
    if (turn != 0) return turn;
    const Vec2 along = to - from;
    const int pushed = orientation(Vec2::Zero(), along, push);
    return pushed != 0 ? pushed : orientation(Vec2::Zero(), along, perp(push));
}

/// Every crossing of an edge of A with an edge of B.
inline std::vector<Crossing> crossings_of(const Pair& pair)
{
    std::vector<Crossing> crossings;
    for (const Edge& edge_a : pair.polygon[0]->edges()) {
        const Vec2& p = pair.vertices[0][edge_a.from];
        const Vec2& q = pair.vertices[0][edge_a.to];
        for (const Edge& edge_b : pair.polygon[1]->edges()) {
            const Vec2& u = pair.vertices[1][edge_b.from];
            const Vec2& v = pair.vertices[1][edge_b.to];

            // [collide.vertex_edge.both]
            // A is pushed; B, seen from A, the other way
            const int p_side = side(u, v, p, pair.push);
            if (p_side == side(u, v, q, pair.push)) continue;
            if (side(p, q, u, -pair.push) == side(p, q, v, -pair.push)) continue;
            // [collide.vertex_edge.both]

            // [collide.vertex_edge.place]
            const double turn = cross(q - p, v - u);
            Crossing crossing;
            crossing.edge[0] = edge_a.from;
            crossing.edge[1] = edge_b.from;
            crossing.a_enters = p_side < 0;
            if (turn != 0.0) {
                crossing.along[0] = std::clamp(cross(u - p, v - u) / turn, 0.0, 1.0);
                crossing.along[1] = std::clamp(cross(u - p, q - p) / turn, 0.0, 1.0);
            }
            crossing.point = p + crossing.along[0] * (q - p);
            crossings.push_back(crossing);
            // [collide.vertex_edge.place]
        }
    }
    return crossings;
}

/// The crossings on each edge of one body, in the order in which its boundary meets them.
inline std::vector<std::vector<int>> order_along(const Pair& pair, std::span<const Crossing> crossings, int body)
{
    std::vector<std::vector<int>> on_edge(pair.vertices[body].size());
    for (int k = 0; k < static_cast<int>(crossings.size()); ++k) on_edge[crossings[k].edge[body]].push_back(k);
    for (std::vector<int>& list : on_edge) {
        std::sort(list.begin(), list.end(), [&](int j, int k) {
            return std::tuple(crossings[j].along[body], j) < std::tuple(crossings[k].along[body], k);
        });

        // Ways in and ways out take turns; where rounding has put two of them in the wrong order, exchange them
        for (std::size_t k = 1; k + 1 < list.size(); ++k) {
            if (crossings[list[k]].a_enters == crossings[list[k - 1]].a_enters) std::swap(list[k], list[k + 1]);
        }
    }
    return on_edge;
}

/// What bounds one common piece of A and B.
struct Piece
{
    std::vector<int> vertices[2]; ///< of A inside B, of B inside A
    std::vector<int> edges[2];    ///< that run along the piece
    std::vector<Vec2> corners;    ///< all round, crossings included
};

/// Walk round the common piece that begins where A enters B at the crossing `first`, along
/// A and along B in turn. None if the walk doesn't close, which only rounding can cause.
inline std::optional<Piece> walk(const Pair& pair, std::span<Crossing> crossings,
                                 const std::vector<std::vector<int>> (&on_edge)[2], int first)
{
    Piece piece;
    int at = first;
    int body = 0;
    do {
        Crossing& from = crossings[at];
        if (from.is_used) return std::nullopt;
        from.is_used = true;
        piece.corners.push_back(from.point);

        // [collide.vertex_edge.next]
        // Look for the next crossing behind this one, then on the edges that follow
        int edge = from.edge[body];
        const std::vector<int>& list = on_edge[body][edge];
        auto next = std::find(list.begin(), list.end(), at) + 1;
        auto end = list.end();
        piece.edges[body].push_back(edge);
        std::size_t steps = 0;
        while (next == end) {
            edge = pair.polygon[body]->edges()[edge].to;
            piece.vertices[body].push_back(edge);
            piece.edges[body].push_back(edge);
            piece.corners.push_back(pair.vertices[body][edge]);
            next = on_edge[body][edge].begin();
            end = on_edge[body][edge].end();
            if (++steps > pair.vertices[body].size()) return std::nullopt;
        }
        // [collide.vertex_edge.next]
        at = *next;
        body = 1 - body;
    } while (at != first || body != 0);
    return piece;
}

/// How deep the other body has come in over one edge.
struct Entry
{
    int owner = 0; ///< 0: the edge is A's, 1: B's
    int edge = 0;
    int vertex = -1;    ///< of the other body, the deepest; -1 where none is inside
    double depth = 0.0; ///< [m]
};

/// What rounding and the width of a touch do to a depth measured along an edge.  [m]
inline double allowance(const Pair& pair, const Edge& edge)
{
    return pair.rounding + tolerance::k_touch * edge.length;
}

/// Neither neighbour of the entry's vertex lies deeper: pushed out along the edge's normal, this vertex leaves last.
inline bool leaves_last(const Pair& pair, const Entry& entry)
{
    const int other = 1 - entry.owner;
    const Polygon& polygon = *pair.polygon[other];
    const std::vector<Vec2>& vertices = pair.vertices[other];
    const Vec2& normal = pair.normals[entry.owner][entry.edge];
    const double allowed = allowance(pair, pair.polygon[entry.owner]->edges()[entry.edge]);
    for (const int neighbour : {polygon.edges()[entry.vertex].to, polygon.previous(entry.vertex)}) {
        if (normal.dot(vertices[neighbour] - vertices[entry.vertex]) < -allowed) return false;
    }
    return true;
}

/// How deep the other's vertices in a piece lie below one of its edges. None if there are
/// no such vertices, or if all lie above the edge's line, as happens beside a reflex
/// corner: then they have come in over another edge.
inline std::optional<Entry> entry_over(const Pair& pair, const Piece& piece, int owner, int edge)
{
    const int other = 1 - owner;
    const Vec2& start = pair.vertices[owner][edge];
    const Vec2& normal = pair.normals[owner][edge];
    std::optional<Entry> entry;
    for (const int vertex : piece.vertices[other]) {
        const double depth = -normal.dot(pair.vertices[other][vertex] - start);
        if (!entry || depth > entry->depth) entry = {owner, edge, vertex, depth};
    }
    if (entry && entry->depth < -allowance(pair, pair.polygon[owner]->edges()[edge])) return std::nullopt;
    return entry;
}

/// The width of a piece below one of its edges.
inline Entry width_below(const Pair& pair, const Piece& piece, int owner, int edge)
{
    Entry width{owner, edge, -1, 0.0};
    for (const Vec2& corner : piece.corners) {
        const double depth = -pair.normals[owner][edge].dot(corner - pair.vertices[owner][edge]);
        width.depth = std::max(width.depth, depth);
    }
    return width;
}

/// The edge of a piece over which the least depth has been reached: one over which the
/// vertex leaves last, if there is one; if no vertex is inside, the edge with the least
/// width below it.
inline Entry shallowest_entry(const Pair& pair, const Piece& piece)
{
    std::optional<Entry> entered;
    std::optional<Entry> narrowest;
    bool entered_leaves_last = false;
    for (int owner = 0; owner < 2; ++owner) {
        for (const int edge : piece.edges[owner]) {
            const Entry width = width_below(pair, piece, owner, edge);
            if (!narrowest || width.depth < narrowest->depth) narrowest = width;

            const std::optional<Entry> entry = entry_over(pair, piece, owner, edge);
            if (!entry) continue;
            const bool last = leaves_last(pair, *entry);
            const bool is_less = last == entered_leaves_last && entered && entry->depth < entered->depth;
            if (entered && !(last && !entered_leaves_last) && !is_less) continue;
            entered = entry;
            entered_leaves_last = last;
        }
    }
    return entered ? *entered : *narrowest; // every piece has edges
}

/// The point of the entered body's edge line above the contact: the foot of the deepest
/// vertex, or the middle of the stretch that an edge at this vertex and the entered edge
/// share, if the two are parallel.
inline Vec2 foot_of(const Pair& pair, const Entry& entry)
{
    const int other = 1 - entry.owner;
    const Edge& edge = pair.polygon[entry.owner]->edges()[entry.edge];
    const Vec2& start = pair.vertices[entry.owner][edge.from];
    const Vec2 tangent = perp(pair.normals[entry.owner][entry.edge]);
    const Vec2& deepest = pair.vertices[other][entry.vertex];
    double along = tangent.dot(deepest - start);
    // [collide.vertex_edge.shared]
    for (const int k : {pair.polygon[other]->previous(entry.vertex), entry.vertex}) {
        const Edge& facing = pair.polygon[other]->edges()[k];
        const double from = tangent.dot(pair.vertices[other][facing.from] - start);
        const double to = tangent.dot(pair.vertices[other][facing.to] - start);
        const double low = std::max(0.0, std::min(from, to));
        const double high = std::min(edge.length, std::max(from, to));

        // Parallel means: over the shared stretch, the gap changes by no more than rounding
        // and the width of a touch
        const double tilt = cross(tangent, perp(pair.normals[other][k]));
        const double shift = std::abs(tilt) * (high - low);
        if (high > low && shift <= allowance(pair, edge)) along = 0.5 * (low + high);
    }
    // [collide.vertex_edge.shared]
    return start + along * tangent;
}

inline Pair in_frame_of_a(const Polygon& a, const Polygon& b, const Pose& a_from_b)
{
    Pair pair;
    pair.polygon[0] = &a;
    pair.polygon[1] = &b;
    for (const Vec2& vertex : a.vertices()) pair.vertices[0].push_back(vertex);
    for (const Edge& edge : a.edges()) pair.normals[0].push_back(edge.normal);
    for (const Vec2& vertex : b.vertices()) pair.vertices[1].push_back(a_from_b * vertex);
    for (const Edge& edge : b.edges()) pair.normals[1].push_back(a_from_b.rotation * edge.normal);

    const double distance = a_from_b.position.norm();
    pair.push = distance > 0.0 ? a_from_b.position : Vec2(1.0, 0.0);
    pair.rounding = tolerance::coordinate_rounding(distance + a.radius() + b.radius());
    return pair;
}

} // namespace vertex_edge

/// Where two overlapping polygons have entered each other, by following their boundaries; convex or not, with or
/// without holes. Normals point from A to B.
///
/// Every piece that the two have in common has a boundary that consists of chains of vertices of A inside B and of B
/// inside A, joined where edges cross. One corner inside, between two crossings with the same edge, is
/// `corner_has_entered`. Of the edges that bound the piece, the one over which the other's chain has entered the least
/// deep makes the contact, at the deepest vertex of that chain: along the edge's own normal, which its turning tells,
/// and at the middle of the common stretch where an edge of the chain is parallel. Where two edges of the piece cross
/// but no vertex is inside (two bars laid crosswise), the depth is the width of the piece, and the contact lies at its
/// middle.
///
/// One contact per piece, in the order of A's edges. None where the polygons are apart or one holds the other without
/// a crossing. Which side of an edge a vertex is on is decided exactly, from vertices rounded once; where one lies
/// exactly on the other's line, as if A were pushed towards B's origin by less than any number. So two convex polygons
/// that merely touch make a contact of depth zero. `Contact::feature` is as in `make_manifold`.
///
/// Time: the product of the two numbers of edges.
[[nodiscard]] inline std::vector<Contact> entered_contacts(const Polygon& a, const Pose& world_from_a, const Polygon& b,
                                                           const Pose& world_from_b)
{
    using namespace vertex_edge;
    const Pair pair = in_frame_of_a(a, b, relative_pose(world_from_a, world_from_b));
    std::vector<Crossing> crossings = crossings_of(pair);
    const std::vector<std::vector<int>> on_edge[2] = {order_along(pair, crossings, 0), order_along(pair, crossings, 1)};
    std::vector<Contact> contacts;
    for (int k = 0; k < static_cast<int>(crossings.size()); ++k) {
        if (!crossings[k].a_enters || crossings[k].is_used) continue;
        const std::optional<Piece> piece = walk(pair, crossings, on_edge, k);
        if (!piece) continue;

        // [collide.vertex_edge.stands]
        // Find where the contact stands, and go halfway to the other surface
        const Entry entry = shallowest_entry(pair, *piece);
        const Vec2& outward = pair.normals[entry.owner][entry.edge];
        Vec2 point = Vec2::Zero();
        if (entry.vertex >= 0) {
            point = foot_of(pair, entry) - 0.5 * entry.depth * outward;
        } else {
            for (const Vec2& corner : piece->corners) point += corner / static_cast<double>(piece->corners.size());
        }

        const Vec2 from_a_to_b = entry.owner == 0 ? outward : Vec2(-outward);
        const std::uint32_t is_of_b = entry.owner == 0 ? 1u : 0u;
        const std::uint32_t feature = is_of_b | (static_cast<std::uint32_t>(entry.vertex) & 0x7fffu) << 1 |
                                      (static_cast<std::uint32_t>(entry.edge) & 0xffffu) << 16;
        contacts.push_back({world_from_a * point, world_from_a.rotation * from_a_to_b, -entry.depth, feature});
        // [collide.vertex_edge.stands]
    }
    return contacts;
}

} // namespace flying
