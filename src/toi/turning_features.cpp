#include "toi/turning_features.hpp"

#include <algorithm>

#include "math/tolerance.hpp"
#include "toi/bend.hpp"
#include "toi/central_flight.hpp"

namespace flying {
namespace {


/// [touch tolerances] How far below an edge a vertex may lie and still be on it: tolerances
/// differ from window to window, and what one of them let in must not be behind the edge for
/// the next.
constexpr double k_depth = 8.0;



/// Keep the earlier of two ends; of two at one time, the first feature stays.
void keep_earlier(Strike& strike, const MarchEnd& end, const Feature& feature)
{
    if (end.kind != MarchEnd::Kind::none && end.time < strike.time) strike = {end.kind, end.time, feature};
}

/// Nothing later than this is of interest any more.
[[nodiscard]] double horizon(const Strike& strike, const Window& window) { return std::min(strike.time, window.until); }



/// A point as seen from a turning body: where it is in that body's frame, and how fast it
/// moves there.
struct Seen
{
    Vec2 point = Vec2::Zero();
    Vec2 rate = Vec2::Zero();
};



/// offset, rate  of the point relative to the body's position, in the world's frame
/// spin          of the body [rad/s]
[[nodiscard]] Seen seen_from(const Rotation& world_from_body, double spin,
                             const Vec2& offset, const Vec2& rate)
{
    const Rotation body_from_world = inverse(world_from_body);
    const Vec2 point = body_from_world * offset;
    const Vec2 rate_seen = body_from_world * rate - cross(spin, point);
    return {point, rate_seen};
}



[[nodiscard]] EdgeReading read_edge(const Seen& seen, const Edge& edge,
                                    const Vec2& edge_start)
{
    const Vec2 from_start = seen.point - edge_start;
    return {edge.normal.dot(from_start), edge.normal.dot(seen.rate),
            edge.tangent.dot(from_start), edge.tangent.dot(seen.rate)};
}



/// One polygon whose vertices are looked at, or whose edges are.
struct Side
{
    const Polygon& shape;
    const Turning& turning;
    Rotation at_start; ///< of the window
    std::span<const Seam> seams;
};



/// Part of an edge that can be struck: beyond its ends there may be a crack that is none, and a neighbour may hide an end.
struct OpenPart
{
    double from = 0.0; ///< [m]
    double length = 0.0; ///< [m]
};

[[nodiscard]] OpenPart open_part(const Edge& edge, std::span<const Seam> seams)
{
    OpenPart part{0.0, edge.length};
    for (const Seam& seam : seams) {
        const bool is_hidden = seam.hidden == edge.from;
        if (!is_hidden && (seam.open != edge.from || seam.bend == Seam::Bend::ridge)) continue;
        const double longer = is_hidden ? -seam.crack : seam.crack;
        if (seam.corner == edge.from) part.from -= longer;
        part.length += longer;
    }
    return part;
}

/// A corner that is none of the surface which it belongs to.
[[nodiscard]] bool is_no_corner(int vertex, std::span<const Seam> seams)
{
    return std::any_of(seams.begin(), seams.end(), [&](const Seam& seam) {
        return seam.corner == vertex && seam.bend != Seam::Bend::ridge;
    });
}

/// A normal at a corner is one of the surface's. normal  out of the polygon, in its frame
[[nodiscard]] bool is_open(const Polygon& polygon, int vertex, std::span<const Seam> seams, const Vec2& normal)
{
    return std::none_of(seams.begin(), seams.end(), [&](const Seam& seam) {
        return seam.corner == vertex && !is_of_surface(polygon, seam, normal);
    });
}



/// How long a point stays in front of the edge that it is farthest in front of.  [s]
[[nodiscard]] double time_in_front(const Seen& seen, const Polygon& polygon,
                                   const MarchBounds& bounds)
{
    double greatest = bounds.tolerance.touch;
    const Edge* facing = nullptr;
    for (const Edge& edge : polygon.edges()) {
        const double gap = edge.normal.dot(seen.point - polygon.vertices()[edge.from]);
        if (gap > greatest) {
            greatest = gap;
            facing = &edge;
        }
    }
    if (!facing) return 0.0;
    return safe_step(greatest - bounds.tolerance.touch, facing->normal.dot(seen.rate), bounds.bend);
}



/// Vertices of P on edges of Q. `sign` is +1 where the relative flight leads from Q to P, -1
/// where it leads back.
template <typename Relative>
void scan_vertices(const Side& p, const Side& q, const Relative& relative, double sign, FeatureKind kind,
                   const Window& window, Strike& strike)
{
    const Vec2 offset = sign * relative.offset_at(window.from);
    const Vec2 rate = sign * relative.rate_at(window.from);
    const double acceleration = acceleration_bound(relative);
    const double spin_p = p.turning.spin();
    const double spin_q = q.turning.spin();
    const double length = window.until - window.from;
    const double distance = offset.norm() + window.speed * length;


    // No vertex comes nearer to Q in this window than by so much
    const double travel = (window.speed + std::abs(spin_p) * p.shape.radius()) * length;
    const double circle =
        q.shape.radius() * (1.0 + tolerance::k_bounding_margin) + window.tolerance.touch;
    const double near = (circle + travel) * (1.0 + tolerance::k_bounding_margin);


    for (int k = 0; k < static_cast<int>(p.shape.vertices().size()); ++k) {
        if (p.shape.is_reflex(k) || is_no_corner(k, p.seams)) continue;
        const Vec2& vertex = p.shape.vertices()[k];
        const Vec2 r = p.at_start * vertex;
        const Vec2 point = offset + r;
        if (window.skips_far_vertices && point.squaredNorm() > near * near) continue;
        const double arm = vertex.norm();
        const Vec2 point_rate = rate + cross(spin_p, r);


        // Leave a vertex alone that stays out of the circle about Q
        const double bend_of_distance = acceleration + spin_p * spin_p * arm;
        const double reach = point.norm();
        const double outside = reach - circle;
        if (window.skips_far_vertices && outside > 0.0) {
            const double clear = safe_step(outside, point.dot(point_rate) / reach, bend_of_distance);
            if (window.from + clear >= horizon(strike, window)) continue;
        }



        // Nor one that stays in front of an edge of a convex Q, which lies behind all of its edges
        const Seen seen = seen_from(q.at_start, spin_q, point, point_rate);
        MarchBounds bounds;
        bounds.bend = bend_of_point(acceleration, window.speed, distance, arm, spin_p, spin_q);
        bounds.depth = k_depth * window.tolerance.touch;
        bounds.tolerance = window.tolerance;
        bounds.ends = tolerance::coordinate_rounding(q.shape.radius() + arm);
        if (window.skips_far_vertices && q.shape.is_convex() &&
            time_in_front(seen, q.shape, bounds) >= horizon(strike, window) - window.from)
            continue;



        // March on every edge that the first look doesn't rule out
        for (const Edge& edge : q.shape.edges()) {
            const OpenPart part = open_part(edge, q.seams);
            const Vec2 edge_start = q.shape.vertices()[edge.from] + part.from * edge.tangent;
            bounds.length = part.length;
            const EdgeReading first = read_edge(seen, edge, edge_start);
            if (!strikes(first, bounds) && window.from + certain_step(first, bounds) >= horizon(strike, window)) continue;


            const auto read = [&](double time) {
                const Vec2 r_then = p.turning.at(time) * vertex;
                const Vec2 point_then = sign * relative.offset_at(time) + r_then;
                const Vec2 rate_then = sign * relative.rate_at(time) + cross(spin_p, r_then);
                return read_edge(seen_from(q.turning.at(time), spin_q, point_then, rate_then), edge, edge_start);
            };

            const auto counts = [&](double time) {
                const Vec2 normal = inverse(p.turning.at(time)) * Vec2(q.turning.at(time) * edge.normal);
                return is_open(p.shape, k, p.seams, -normal);
            };
            keep_earlier(strike, march(first, read, bounds, window.from, horizon(strike, window), counts),
                         {kind, k, edge.from});
        }

    }
}



/// March of the distance between a point and a centre, less a radius. Distance bends
/// upwards by itself, so that the acceleration alone bounds how fast it can fall.
template <typename Offset, typename Counts>
[[nodiscard]] MarchEnd march_distance(const Offset& offset_and_rate, double radius,
                                      double acceleration, const Window& window,
                                      double until, const Counts& counts)
{
    const double bend = acceleration * (1.0 + tolerance::k_bend_margin);
    const MarchBounds bounds{bend, k_never, k_never, window.tolerance};
    const auto read = [&](double time) {
        const Seen seen = offset_and_rate(time);
        const double distance = seen.point.norm();
        const double rate = seen.point.dot(seen.rate) / distance;
        return EdgeReading{distance - radius, rate, 0.0, 0.0};
    };
    return march(read(window.from), read, bounds, window.from, until, counts);
}


} // namespace


template <typename Relative>
Strike first_strike(const Polygon& a, const Turning& turning_a, const Polygon& b, const Turning& turning_b,
                    const Relative& relative, const Window& window)
{
    Strike strike;
    const Side side_a{a, turning_a, turning_a.at(window.from), window.seams_a};
    const Side side_b{b, turning_b, turning_b.at(window.from), window.seams_b};
    scan_vertices(side_a, side_b, relative, 1.0, FeatureKind::vertex_of_a, window, strike);
    scan_vertices(side_b, side_a, relative, -1.0, FeatureKind::vertex_of_b, window, strike);
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
    bounds.bend = bend_of_point(acceleration, window.speed, distance, 0.0, 0.0, spin);
    bounds.depth = k_depth * window.tolerance.touch;
    bounds.tolerance = window.tolerance;
    bounds.ends = tolerance::coordinate_rounding(b.radius() + a.radius);

    const Seen seen = seen_from(turning_b.at(window.from), spin, relative.offset_at(window.from),
                                relative.rate_at(window.from));
    for (const Edge& edge : b.edges()) {

        // The disc's centre against the edge, moved out by the radius
        const OpenPart part = open_part(edge, window.seams_b);
        bounds.length = part.length;
        const Vec2 moved_start = b.vertices()[edge.from] + a.radius * edge.normal + part.from * edge.tangent;
        const auto read = [&](double time) {
            return read_edge(seen_from(turning_b.at(time), spin, relative.offset_at(time), relative.rate_at(time)), edge,
                             moved_start);
        };
        const EdgeReading first = read_edge(seen, edge, moved_start);
        keep_earlier(strike, march(first, read, bounds, window.from, horizon(strike, window)),
                     {FeatureKind::vertex_of_a, -1, edge.from});



        // And against the corner at its start
        if (b.is_reflex(edge.from) || is_no_corner(edge.from, window.seams_b)) continue;
        const Vec2& corner = b.vertices()[edge.from];
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
        keep_earlier(strike,
                     march_distance(from_corner, a.radius, corner_acceleration, window, horizon(strike, window), counts),
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
                 march_distance(between_centres, a.radius + b.radius, acceleration_bound(relative), window, window.until,
                                counts),
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

        keep_earlier(strike, march(read(window.from), read, bounds, window.from, horizon(strike, window)), {FeatureKind::vertex_of_a, k, -1});
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
