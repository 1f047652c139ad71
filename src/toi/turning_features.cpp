#include "toi/turning_features.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "collide/ways_out.hpp"
#include "math/tolerance.hpp"
#include "toi/bend.hpp"
#include "toi/central_flight.hpp"

namespace flying {
namespace {

/// [touch tolerances] How far below an edge a vertex may lie and still be on it: tolerances differ from window to
/// window, and what one of them let in must not be behind the edge for the next.
constexpr double k_depth = 8.0;

/// Keep the earlier of two ends; of two at one time, the first feature stays.
void keep_earlier(Strike& strike, const MarchEnd& end, const Feature& feature)
{
    if (end.kind != MarchEnd::Kind::none && end.time < strike.time) strike = {end.kind, end.time, feature};
}

/// Nothing later than this is of interest any more.
[[nodiscard]] double horizon(const Strike& strike, const Window& window)
{
    return std::min(strike.time, std::min(window.until, window.horizon));
}

/// A point as seen from a turning body: where it is in that body's frame, and how fast it moves there.
struct Seen
{
    Vec2 point = Vec2::Zero();
    Vec2 rate = Vec2::Zero();
};

/// offset, rate  of the point relative to the body's position, in the world's frame
/// spin          of the body [rad/s]
[[nodiscard]] Seen seen_from(const Rotation& world_from_body, double spin, const Vec2& offset, const Vec2& rate)
{
    const Rotation body_from_world = inverse(world_from_body);
    const Vec2 point = body_from_world * offset;
    const Vec2 rate_seen = body_from_world * rate - cross(spin, point);
    return {point, rate_seen};
}

[[nodiscard]] EdgeReading read_edge(const Seen& seen, const Edge& edge, const Vec2& edge_start)
{
    const Vec2 from_start = seen.point - edge_start;
    return {edge.normal.dot(from_start), edge.normal.dot(seen.rate), edge.tangent.dot(from_start),
            edge.tangent.dot(seen.rate)};
}

/// One polygon whose vertices are looked at, or whose edges are.
struct Side
{
    const Polygon& shape;
    const Turning& turning;
    Rotation at_middle; ///< of the time that is looked at
    std::span<const Seam> seams;
};

/// A point in front of one of a polygon's edges is so for so long before and after. No root is asked for: what bends
/// down and is above zero at both ends of a stretch is so between them.
/// radius  of a disc about the point, or 0  [m]
[[nodiscard]] bool stays_in_front(const Seen& seen, const Polygon& polygon, const MarchBounds& bounds, double half,
                                  double radius = 0.0)
{
    const double least = 0.5 * bounds.bend * half * half + bounds.tolerance.touch + radius;
    for (const Edge& edge : polygon.edges()) {
        const double gap = edge.normal.dot(seen.point - polygon.vertices()[edge.from]);
        if (gap - half * std::abs(edge.normal.dot(seen.rate)) > least) return true;
    }
    return false;
}

/// How A and B are turned at the start of a window: asked for only where something comes near.
class StartRotations
{
public:
    StartRotations(const Turning& a, const Turning& b, double time) : a_(a), b_(b), time_(time) {}

    [[nodiscard]] const std::array<Rotation, 2>& both()
    {
        if (!both_) both_ = both_at(a_, b_, time_);
        return *both_;
    }

private:
    const Turning& a_;
    const Turning& b_;
    double time_;
    std::optional<std::array<Rotation, 2>> both_;
};

/// The vertices of P and the edges of Q within a window, and what all of their readings share.
template <typename Relative>
struct Facing
{
    const Side& p;
    const Side& q;
    const Relative& relative;
    double sign = 1.0; ///< +1 where the relative flight leads from Q to P, -1 where it leads back
    FeatureKind kind = FeatureKind::vertex_of_a;
    const Window& window;
    double distance = 0.0; ///< bound on that of the two positions [m]
    double half = 0.0;     ///< of the time that is looked at [s]
    Vec2 offset_at_middle; ///< from Q to P, in the middle of it [m]
    Vec2 rate_at_middle;   ///< [m/s]
    StartRotations& start;

    [[nodiscard]] Seen see(const Vec2& vertex, double time, const Rotation& world_from_p,
                           const Rotation& world_from_q) const
    {
        const Vec2 r = world_from_p * vertex;
        const Vec2 point = sign * relative.offset_at(time) + r;
        const Vec2 rate = sign * relative.rate_at(time) + cross(p.turning.spin(), r);
        return seen_from(world_from_q, q.turning.spin(), point, rate);
    }

    [[nodiscard]] Seen see_at_start(const Vec2& vertex) const
    {
        const auto& [of_a, of_b] = start.both();
        const bool p_is_a = kind == FeatureKind::vertex_of_a;
        return see(vertex, window.from, p_is_a ? of_a : of_b, p_is_a ? of_b : of_a);
    }

    /// All but the edge's length.
    [[nodiscard]] MarchBounds bounds(double arm) const
    {
        MarchBounds bounds;
        bounds.bend = bend_of_point(acceleration_bound(relative), window.speed, distance, arm, p.turning.spin(),
                                    q.turning.spin());
        bounds.along_bend = bounds.bend;
        bounds.depth = k_depth * window.tolerance.touch;
        bounds.tolerance = window.tolerance;
        bounds.ends = tolerance::coordinate_rounding(q.shape.radius() + arm);
        return bounds;
    }
};

/// Bound on the second derivative of a gap over an edge that doesn't turn. It sees only what falls towards it: what
/// falls along it comes no nearer.  [m/s^2]
template <typename Relative>
[[nodiscard]] double bend_over(const Edge& edge, const Rotation& world_from_q, const Relative& relative, double arm,
                               double spin_p)
{
    const double fall = acceleration_bound(relative, Vec2(world_from_q * edge.normal));
    return bend_of_point(fall, 0.0, 0.0, arm, spin_p, 0.0);
}

/// A vertex that may strike an edge. Without values of its own: most of a list is never written.
struct Approach
{
    double earliest; ///< nothing happens before [s]
    int vertex;
    int edge;
    FeatureKind kind; ///< whose vertex
};

/// Approaches of one window, in the order in which they were found. Few polygons have more; where there is no room,
/// those found so far are followed, and what they strike shortens the window for the rest.
struct Approaches
{
    static constexpr int k_most = 4;
    std::array<Approach, k_most> list;
    int count = 0;
};

/// What comes at the end of an edge strikes nothing there if it slides past the corner.
///
/// seen   the vertex of P, as Q sees it
/// depth  what is no deeper behind a side than this lies on it [m]
[[nodiscard]] bool slides_past(const Side& p, const Side& q, const Seen& seen, const Rotation& q_from_p, int vertex,
                               const Edge& edge, double depth)
{
    const auto slides_past_corner = [&](int end) {
        const Vec2 way = seen.point - q.shape.vertices()[end];
        if (!(way.squaredNorm() <= 4.0 * depth * depth) || q.shape.is_reflex(end)) return false;
        const WaysOut of_p = q_from_p * ways_out(p.shape, vertex);
        return side_slid_along(ways_out(q.shape, end), of_p, way, seen.rate, depth).has_value();
    };
    return slides_past_corner(edge.from) || slides_past_corner(edge.to);
}

/// First strike of one vertex on one edge.
template <typename Relative>
[[nodiscard]] MarchEnd follow(const Facing<Relative>& facing, int vertex, int edge_index, double stop)
{
    const Side& p = facing.p;
    const Side& q = facing.q;
    const Vec2& corner = p.shape.vertices()[vertex];
    const Edge& edge = q.shape.edges()[edge_index];
    const OpenPart part = open_part(edge, q.seams);
    const Vec2 edge_start = q.shape.vertices()[edge.from] + part.from * edge.tangent;
    MarchBounds bounds = facing.bounds(corner.norm());
    bounds.length = part.length;
    if (q.turning.spin() == 0.0)
        bounds.bend = bend_over(edge, q.at_middle, facing.relative, corner.norm(), p.turning.spin());

    const auto read = [&](double time) {
        const auto [world_from_p, world_from_q] = both_at(p.turning, q.turning, time);
        return read_edge(facing.see(corner, time, world_from_p, world_from_q), edge, edge_start);
    };
    const auto counts = [&](double time) {
        const auto [world_from_p, world_from_q] = both_at(p.turning, q.turning, time);
        const Vec2 normal = inverse(world_from_p) * Vec2(world_from_q * edge.normal);
        if (!is_open(p.shape, vertex, p.seams, -normal)) return false;
        const Seen seen = facing.see(corner, time, world_from_p, world_from_q);
        return !slides_past(p, q, seen, inverse(world_from_q) * world_from_p, vertex, edge, bounds.depth);
    };
    const double from = facing.window.from;
    const EdgeReading first = read_edge(facing.see_at_start(corner), edge, edge_start);
    return march(first, read, bounds, from, facing.window.until, stop, counts);
}

/// Follow what approaches, that which may strike first before the others: most of them can't be earlier than its
/// strike, and needn't be followed. Of two at one time, the one that was found first stays.
template <typename Relative>
void follow_all(Approaches& approaches, const Facing<Relative>& of_a, const Facing<Relative>& of_b, Strike& strike)
{
    int struck = -1; // what an earlier list has found comes before all of these
    for (int left = approaches.count; left > 0; --left) {
        int next = 0;
        for (int k = 1; k < approaches.count; ++k) {
            if (approaches.list[k].earliest < approaches.list[next].earliest) next = k;
        }
        Approach& approach = approaches.list[next];
        const double limit = next < struck ? next_after(strike.time) : strike.time;
        if (approach.earliest >= limit) break;
        approach.earliest = k_never;

        const Facing<Relative>& facing = approach.kind == FeatureKind::vertex_of_a ? of_a : of_b;
        const MarchEnd end = follow(facing, approach.vertex, approach.edge, std::min(limit, facing.window.horizon));
        if (end.kind == MarchEnd::Kind::none || end.time >= limit) continue;
        strike = {end.kind, end.time, {approach.kind, approach.vertex, approach.edge}};
        struck = next;
    }
    approaches.count = 0;
}

/// Vertices of P that are to be looked at, of a few.
struct Candidates
{
    static constexpr int k_most = 16;
    std::array<int, k_most> list;
    int count = 0;
};

/// Vertices of P, no more than so many from `first` on, that may come into Q's circle. Seen from P, where none of them
/// turns. Most stay out and which of them do can't be guessed, so that nothing here waits for a guess.
template <typename Relative>
[[nodiscard]] Candidates near_vertices(const Facing<Relative>& facing, int first)
{
    const Side& p = facing.p;
    const Window& window = facing.window;
    const Rotation p_from_world = inverse(p.at_middle);
    const Vec2 offset = p_from_world * facing.offset_at_middle;
    const Vec2 rate = p_from_world * facing.rate_at_middle;
    const double spin = p.turning.spin();

    // Q's circle, and how far out of it a point that flies straight must remain to stay out
    const double circle = facing.q.shape.radius() * (1.0 + tolerance::k_bounding_margin) + window.tolerance.touch;
    const double bend = acceleration_bound(facing.relative) + spin * spin * p.shape.radius();
    const double near = window.skips_far_vertices ? circle + 0.5 * bend * facing.half * facing.half : k_never;

    // Half the rate of a vertex's squared distance, of which its turning leaves a part that is linear in where it is
    const double rate_of_centre = offset.dot(rate);
    const Vec2 rate_of_vertex = rate - cross(spin, offset);

    Candidates candidates;
    const std::span<const Vec2> vertices = p.shape.vertices();
    const int end = std::min(static_cast<int>(vertices.size()), first + Candidates::k_most);
    for (int k = first; k < end; ++k) {
        const Vec2& r = vertices[k];
        const double distance2 = (offset + r).squaredNorm();
        const double least = distance2 - facing.half * std::abs(rate_of_centre + rate_of_vertex.dot(r));
        const bool stays_out = (least > 0.0) & (least * least > near * near * distance2);
        candidates.list[candidates.count] = k;
        candidates.count += stays_out ? 0 : 1;
    }
    return candidates;
}

/// Find the edges of Q that one vertex of P may strike.
template <typename Relative>
void scan_edges(const Facing<Relative>& facing, int vertex, MarchBounds& bounds, const Facing<Relative>& of_a,
                const Facing<Relative>& of_b, Approaches& approaches, Strike& strike)
{
    const Side& p = facing.p;
    const Side& q = facing.q;
    const Window& window = facing.window;
    const Vec2& corner = p.shape.vertices()[vertex];
    const Vec2 r = p.at_middle * corner;
    const Seen seen = seen_from(q.at_middle, q.turning.spin(), facing.offset_at_middle + r,
                                facing.rate_at_middle + cross(p.turning.spin(), r));

    // Leave a vertex alone that stays in front of an edge of a convex Q, which lies behind them all
    if (window.skips_far_vertices && q.shape.is_convex() && stays_in_front(seen, q.shape, bounds, facing.half)) return;

    // Keep the edges that this look doesn't rule out
    std::optional<Seen> at_start;
    for (const Edge& edge : q.shape.edges()) {
        const OpenPart part = open_part(edge, q.seams);
        bounds.length = part.length;
        const Vec2 edge_start = q.shape.vertices()[edge.from] + part.from * edge.tangent;
        if (window.skips_far_vertices && is_clear_within(read_edge(seen, edge, edge_start), bounds, facing.half))
            continue;
        if (!at_start) at_start = facing.see_at_start(corner);
        const EdgeReading first = read_edge(*at_start, edge, edge_start);
        const double wait = strikes(first, bounds) ? 0.0 : certain_step(first, bounds);
        if (window.from + wait >= horizon(strike, window)) continue;
        if (approaches.count == Approaches::k_most) follow_all(approaches, of_a, of_b, strike);
        approaches.list[approaches.count++] = {window.from + wait, vertex, edge.from, facing.kind};
    }
}

/// Find the vertices of P that may strike an edge of Q.
template <typename Relative>
void scan_vertices(const Facing<Relative>& facing, const Facing<Relative>& of_a, const Facing<Relative>& of_b,
                   Approaches& approaches, Strike& strike)
{
    const Side& p = facing.p;
    MarchBounds bounds = facing.bounds(p.shape.radius());
    const int count = static_cast<int>(p.shape.vertices().size());
    for (int first = 0; first < count; first += Candidates::k_most) {
        const Candidates candidates = near_vertices(facing, first);
        for (int k = 0; k < candidates.count; ++k) {
            const int vertex = candidates.list[k];
            if (p.shape.is_reflex(vertex) || (!p.seams.empty() && is_no_corner(vertex, p.seams))) continue;
            scan_edges(facing, vertex, bounds, of_a, of_b, approaches, strike);
        }
    }
}

/// March of the distance between a point and a centre, less a radius. Distance bends
/// upwards by itself, so that the acceleration alone bounds how fast it can fall.
template <typename Offset, typename Counts>
[[nodiscard]] MarchEnd march_distance(const Offset& offset_and_rate, double radius, double acceleration,
                                      const Window& window, double stop, const Counts& counts)
{
    const double bend = acceleration * (1.0 + tolerance::k_bend_margin);
    const MarchBounds bounds{bend, k_never, k_never, window.tolerance};
    const auto read = [&](double time) {
        const Seen seen = offset_and_rate(time);
        const double distance = seen.point.norm();
        const double rate = seen.point.dot(seen.rate) / distance;
        return EdgeReading{distance - radius, rate, 0.0, 0.0};
    };
    return march(read(window.from), read, bounds, window.from, window.until, stop, counts);
}

} // namespace

template <typename Relative>
Strike first_strike(const Polygon& a, const Turning& turning_a, const Polygon& b, const Turning& turning_b,
                    const Relative& relative, const Window& window)
{
    // A bound on what bends is four times as close when it is taken from the middle of a stretch as from its beginning
    const double half = window.half();
    const double middle = window.from + half;
    StartRotations start(turning_a, turning_b, window.from);
    const auto [a_at_middle, b_at_middle] = both_at(turning_a, turning_b, middle);
    const Side side_a{a, turning_a, a_at_middle, window.seams_a};
    const Side side_b{b, turning_b, b_at_middle, window.seams_b};
    const double distance = relative.offset_at(window.from).norm() + window.speed * (window.until - window.from);
    const Vec2 offset = relative.offset_at(middle);
    const Vec2 rate = relative.rate_at(middle);
    const Facing<Relative> of_a{side_a, side_b, relative, 1.0,  FeatureKind::vertex_of_a, window, distance,
                                half,   offset, rate,     start};
    const Facing<Relative> of_b{side_b, side_a,  relative, -1.0, FeatureKind::vertex_of_b, window, distance,
                                half,   -offset, -rate,    start};
    Strike strike;
    Approaches approaches;
    scan_vertices(of_a, of_a, of_b, approaches, strike);
    scan_vertices(of_b, of_a, of_b, approaches, strike);
    follow_all(approaches, of_a, of_b, strike);
    return strike;
}

template <typename Relative>
Strike first_strike(const Disc& a, const Polygon& b, const Turning& turning_b, const Relative& relative,
                    const Window& window)
{
    Strike strike;
    const double acceleration = acceleration_bound(relative);
    const double spin = turning_b.spin();
    const double distance = relative.offset_at(window.from).norm() + window.speed * (window.until - window.from);
    MarchBounds bounds;
    bounds.along_bend = bend_of_point(acceleration, window.speed, distance, 0.0, 0.0, spin);
    bounds.bend = bounds.along_bend;
    bounds.depth = k_depth * window.tolerance.touch;
    bounds.tolerance = window.tolerance;
    bounds.ends = tolerance::coordinate_rounding(b.radius() + a.radius);

    const auto see = [&](double time) {
        return seen_from(turning_b.at(time), spin, relative.offset_at(time), relative.rate_at(time));
    };
    // Leave a disc alone that stays in front of an edge of a convex polygon
    const double half = window.half();
    const Seen at_middle = see(window.from + half);
    const bool leaves = window.skips_far_vertices && b.is_convex() && window.seams_b.empty();
    if (leaves && stays_in_front(at_middle, b, bounds, half, a.radius)) return strike;
    const Seen at_start = see(window.from);
    const double way = half * (at_middle.rate.norm() + 0.5 * bounds.along_bend * half); // that it goes, at most
    const double near = window.skips_far_vertices ? a.radius + window.tolerance.touch + way : k_never;
    for (const Edge& edge : b.edges()) {
        // The disc's centre against the edge, moved out by the radius
        const OpenPart part = open_part(edge, window.seams_b);
        bounds.length = part.length;
        if (spin == 0.0) bounds.bend = bend_over(edge, turning_b.at(window.from), relative, 0.0, 0.0);
        const Vec2 moved_start = b.vertices()[edge.from] + a.radius * edge.normal + part.from * edge.tangent;
        const auto read = [&](double time) { return read_edge(see(time), edge, moved_start); };
        if (!window.skips_far_vertices || !is_clear_within(read_edge(at_middle, edge, moved_start), bounds, half)) {
            const EdgeReading first = read_edge(at_start, edge, moved_start);
            const MarchEnd end = march(first, read, bounds, window.from, window.until, horizon(strike, window));
            keep_earlier(strike, end, {FeatureKind::vertex_of_a, -1, edge.from});
        }

        // And against the corner at its start
        if (b.is_reflex(edge.from) || is_no_corner(edge.from, window.seams_b)) continue;
        const Vec2& corner = b.vertices()[edge.from];
        if ((at_middle.point - corner).squaredNorm() > near * near) continue;
        const auto from_corner = [&](double time) {
            const Vec2 r = turning_b.at(time) * corner;
            const Vec2 offset = relative.offset_at(time) - r;
            const Vec2 rate = relative.rate_at(time) - cross(spin, r);
            return Seen{offset, rate};
        };
        const double corner_acceleration = acceleration + spin * spin * corner.norm();
        const auto counts = [&](double time) {
            const Vec2 normal = inverse(turning_b.at(time)) * from_corner(time).point.normalized();
            return is_open(b, edge.from, window.seams_b, normal);
        };
        keep_earlier(
            strike, march_distance(from_corner, a.radius, corner_acceleration, window, horizon(strike, window), counts),
            {FeatureKind::vertex_of_b, edge.from, -1});
    }
    return strike;
}

template <typename Relative>
Strike first_strike(const Disc& a, const Disc& b, const Relative& relative, const Window& window)
{
    Strike strike;
    const auto between_centres = [&](double time) { return Seen{relative.offset_at(time), relative.rate_at(time)}; };
    const auto counts = [](double) { return true; };
    keep_earlier(strike,
                 march_distance(between_centres, a.radius + b.radius, acceleration_bound(relative), window,
                                window.until, counts),
                 {});
    return strike;
}

template <typename Relative>
Strike first_strike(const Polygon& a, const Turning& turning_a, const HalfPlane& wall, const Relative& relative,
                    const Window& window)
{
    Strike strike;
    const double spin = turning_a.spin();
    const double fall = acceleration_bound(relative, wall.normal);
    for (int k = 0; k < static_cast<int>(a.vertices().size()); ++k) {
        if (a.is_reflex(k)) continue;
        const Vec2& vertex = a.vertices()[k];
        const double bend = (fall + spin * spin * vertex.norm()) * (1.0 + tolerance::k_bend_margin);
        const MarchBounds bounds{bend, k_never, k_never, window.tolerance};
        const auto read = [&](double time) {
            const Vec2 r = turning_a.at(time) * vertex;
            const double centre = wall.normal.dot(relative.offset_at(time)) - wall.offset;
            const double height = centre + wall.normal.dot(r);
            const Vec2 rate = relative.rate_at(time) + cross(spin, r);
            return EdgeReading{height, wall.normal.dot(rate), 0.0, 0.0};
        };
        keep_earlier(strike, march(read(window.from), read, bounds, window.from, window.until, horizon(strike, window)),
                     {FeatureKind::vertex_of_a, k, -1});
    }
    return strike;
}

template Strike first_strike(const Polygon&, const Turning&, const Polygon&, const Turning&, const RelativeFlight&,
                             const Window&);
template Strike first_strike(const Disc&, const Polygon&, const Turning&, const RelativeFlight&, const Window&);
template Strike first_strike(const Disc&, const Disc&, const RelativeFlight&, const Window&);
template Strike first_strike(const Polygon&, const Turning&, const HalfPlane&, const RelativeFlight&, const Window&);

template Strike first_strike(const Polygon&, const Turning&, const Polygon&, const Turning&, const CentralPairFlight&,
                             const Window&);
template Strike first_strike(const Disc&, const Polygon&, const Turning&, const CentralPairFlight&, const Window&);
template Strike first_strike(const Disc&, const Disc&, const CentralPairFlight&, const Window&);
template Strike first_strike(const Polygon&, const Turning&, const HalfPlane&, const CentralPairFlight&, const Window&);

} // namespace flying
