#include "stress/dense_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flying::stress {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// Where a body is at a moment.
struct Place
{
    Vec2 position = Vec2::Zero();
    double cosine = 1.0;
    double sine = 0.0;

    [[nodiscard]] Vec2 out(const Vec2& p) const { return position + Vec2(cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y()); }
    [[nodiscard]] Vec2 in(const Vec2& world) const
    {
        const Vec2 p = world - position;
        return {cosine * p.x() + sine * p.y(), cosine * p.y() - sine * p.x()};
    }
};

Place place_of(const Outline& outline, const Flyer& flyer, double time)
{
    const BodyState& state = flyer.state;
    const double t = time - state.time;
    Place place;
    if (flyer.central) place.position = flight(state, *flyer.central, time).position;
    else place.position = state.position + t * state.velocity + 0.5 * t * t * flyer.acceleration;
    if (outline.kind == Outline::Kind::rings) {
        place.cosine = std::cos(state.angle + state.spin * t);
        place.sine = std::sin(state.angle + state.spin * t);
    }
    return place;
}

/// Distance of a point from the rings, both in their frame, and the side it lies on.
struct PointGap
{
    double distance2 = k_infinity;
    bool inside = false;
};

PointGap point_gap(const Vec2& p, const Outline& rings)
{
    PointGap gap;
    for (const Outline::Segment& segment : rings.segments) {
        const double x = p.x() - segment.start.x();
        const double y = p.y() - segment.start.y();
        const double share = std::clamp((x * segment.way.x() + y * segment.way.y()) * segment.inv_length2, 0.0, 1.0);
        const double dx = x - share * segment.way.x();
        const double dy = y - share * segment.way.y();
        gap.distance2 = std::min(gap.distance2, dx * dx + dy * dy);

        // A ray to the right crosses the edges an odd number of times where the point lies inside
        const bool starts_below = y >= 0.0;
        const bool ends_below = y >= segment.way.y();
        if (starts_below != ends_below && (x * segment.way.y() < y * segment.way.x()) == (segment.way.y() > 0.0))
            gap.inside = !gap.inside;
    }
    return gap;
}

/// Vertices of P against the edges of Q.
void compare(const Outline& p, const Place& place_p, const Outline& q, const Place& place_q, double& least2, double& depth2)
{
    for (const Vec2& vertex : p.vertices) {
        const Vec2 point = place_q.in(place_p.out(vertex));
        const double reach = q.radius + std::sqrt(least2);
        if (point.squaredNorm() > reach * reach) continue;
        const PointGap gap = point_gap(point, q);
        if (gap.inside) depth2 = std::max(depth2, gap.distance2);
        else least2 = std::min(least2, gap.distance2);
    }
}

double gap_of(const Outline& a, const Place& place_a, const Outline& b, const Place& place_b)
{
    using Kind = Outline::Kind;
    if (b.kind == Kind::wall) {
        if (a.kind == Kind::disc) return b.normal.dot(place_a.position) - b.offset - a.radius;
        double least = k_infinity;
        for (const Vec2& vertex : a.vertices) least = std::min(least, b.normal.dot(place_a.out(vertex)) - b.offset);
        return least;
    }
    if (a.kind == Kind::disc && b.kind == Kind::disc)
        return (place_a.position - place_b.position).norm() - (a.radius + b.radius);
    if (a.kind == Kind::disc || b.kind == Kind::disc) {
        const bool a_is_disc = a.kind == Kind::disc;
        const Outline& rings = a_is_disc ? b : a;
        const Vec2 centre = a_is_disc ? place_b.in(place_a.position) : place_a.in(place_b.position);
        const PointGap gap = point_gap(centre, rings);
        const double distance = std::sqrt(gap.distance2);
        return (gap.inside ? -distance : distance) - (a_is_disc ? a.radius : b.radius);
    }
    const double apart = (place_a.position - place_b.position).norm() + a.radius + b.radius;
    double least2 = apart * apart;
    double depth2 = -1.0;
    compare(a, place_a, b, place_b, least2, depth2);
    compare(b, place_b, a, place_a, least2, depth2);
    return depth2 >= 0.0 ? -std::sqrt(depth2) : std::sqrt(least2);
}

/// Bounds on the approach of the two surfaces from a moment on: L t + a t^2 / 2 at most, for so long.
struct Approach
{
    double speed = 0.0;        ///< of the positions [m/s]
    double tips = 0.0;         ///< of the farthest points about their positions [m/s]
    double acceleration = 0.0; ///< [m/s^2]
    double lasts = k_infinity; ///< [s]
};

double tip_speed(const Outline& outline, const Flyer& flyer)
{
    return outline.kind == Outline::Kind::rings ? std::abs(flyer.state.spin) * outline.radius : 0.0;
}

/// Under a centre's pull, acceleration is at most four times that of now until the distance has halved, which takes at
/// least r / 2 over the greatest speed on the way.
void add_central(const Flyer& flyer, double time, Approach& approach)
{
    const BodyState now = flight(flyer.state, *flyer.central, time);
    const double r = (now.position - flyer.central->centre).norm();
    const double mu = flyer.central->mu;
    const double greatest = std::sqrt(now.velocity.squaredNorm() + 2.0 * mu / r);
    approach.acceleration += 4.0 * mu / (r * r);
    approach.lasts = std::min(approach.lasts, 0.5 * r / greatest);
}

Vec2 velocity_of(const Flyer& flyer, double time)
{
    if (flyer.central) return flight(flyer.state, *flyer.central, time).velocity;
    return flyer.state.velocity + (time - flyer.state.time) * flyer.acceleration;
}

Approach approach_of(const FlyingPair& pair, double time)
{
    Approach approach;
    approach.tips = tip_speed(pair.a, pair.flyer_a) + tip_speed(pair.b, pair.flyer_b);
    approach.speed = (velocity_of(pair.flyer_a, time) - velocity_of(pair.flyer_b, time)).norm();
    approach.acceleration = (pair.flyer_a.acceleration - pair.flyer_b.acceleration).norm();
    if (pair.flyer_a.central) add_central(pair.flyer_a, time, approach);
    if (pair.flyer_b.central) add_central(pair.flyer_b, time, approach);
    return approach;
}

double step_for(double gap, double speed, const Approach& approach)
{
    const double step = 2.0 * gap / (speed + std::sqrt(speed * speed + 2.0 * approach.acceleration * gap));
    return std::min(step, approach.lasts);
}

double smaller_size(const FlyingPair& pair)
{
    return pair.b.kind == Outline::Kind::wall ? pair.a.radius : std::min(pair.a.radius, pair.b.radius);
}

/// The least gap between two moments with one least value between them (golden section).
double refine(const FlyingPair& pair, double low, double high, double& time, long& samples)
{
    constexpr double k_section = 0.61803398874989485;
    double p = high - k_section * (high - low);
    double q = low + k_section * (high - low);
    double gap_p = gap_at(pair, p);
    double gap_q = gap_at(pair, q);
    for (int k = 0; k < 60; ++k) {
        if (gap_p < gap_q) {
            high = q;
            q = p;
            gap_q = gap_p;
            p = high - k_section * (high - low);
            gap_p = gap_at(pair, p);
        } else {
            low = p;
            p = q;
            gap_p = gap_q;
            q = low + k_section * (high - low);
            gap_q = gap_at(pair, q);
        }
    }
    samples += 62;
    time = gap_p < gap_q ? p : q;
    return std::min(gap_p, gap_q);
}

bool edges_cross(const Vec2& p, const Vec2& p_way, const Vec2& q, const Vec2& q_way)
{
    const Vec2 d = q - p;
    const double turn = cross(p_way, q_way);
    if (turn == 0.0) return false;
    const double s = cross(d, q_way) / turn;
    const double t = cross(d, p_way) / turn;
    return s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0;
}

/// How far a body's places at neighbouring doubles are off the flight between them: past a close turn round the centre
/// more than any count of roundings tells (pair 201319863).  [m]
double scatter_at(const Outline& outline, const Flyer& flyer, double time)
{
    const Vec2 place = place_of(outline, flyer, time).position;
    const Vec2 velocity = velocity_of(flyer, time);
    double greatest = 0.0;
    double next = time;
    for (int k = 0; k < 32; ++k) {
        next = std::nextafter(next, k_infinity);
        const Vec2 flown = place + (next - time) * velocity;
        greatest = std::max(greatest, (place_of(outline, flyer, next).position - flown).norm());
    }
    return greatest;
}

} // namespace

Outline disc_outline(double radius)
{
    Outline outline;
    outline.radius = radius;
    return outline;
}

Outline wall_outline(const Vec2& normal, double offset)
{
    Outline outline;
    outline.kind = Outline::Kind::wall;
    outline.normal = normal;
    outline.offset = offset;
    return outline;
}

Outline rings_outline(const std::vector<std::vector<Vec2>>& rings)
{
    Outline outline;
    outline.kind = Outline::Kind::rings;
    for (const std::vector<Vec2>& ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec2 way = ring[(k + 1) % ring.size()] - ring[k];
            outline.vertices.push_back(ring[k]);
            outline.segments.push_back({ring[k], way, 1.0 / way.squaredNorm()});
            outline.radius = std::max(outline.radius, ring[k].norm());
        }
    }
    return outline;
}

double gap_at(const FlyingPair& pair, double time)
{
    return gap_of(pair.a, place_of(pair.a, pair.flyer_a, time), pair.b, place_of(pair.b, pair.flyer_b, time));
}

bool overlap_at(const FlyingPair& pair, double time)
{
    if (gap_at(pair, time) <= 0.0) return true;
    const Place place_a = place_of(pair.a, pair.flyer_a, time);
    const Place place_b = place_of(pair.b, pair.flyer_b, time);
    for (const Outline::Segment& p : pair.a.segments) {
        for (const Outline::Segment& q : pair.b.segments) {
            const Vec2 p_start = place_a.out(p.start);
            const Vec2 q_start = place_b.out(q.start);
            const Vec2 p_way = place_a.out(p.start + p.way) - p_start;
            const Vec2 q_way = place_b.out(q.start + q.way) - q_start;
            if (edges_cross(p_start, p_way, q_start, q_way)) return true;
        }
    }
    return false;
}

double rounding_at(const FlyingPair& pair, double time)
{
    constexpr double k_epsilon = std::numeric_limits<double>::epsilon();
    const bool is_wall = pair.b.kind == Outline::Kind::wall;
    const Place place_a = place_of(pair.a, pair.flyer_a, time);
    double reach = place_a.position.norm() + pair.a.radius;
    double scatter = 0.0;
    if (const CentralField* central = pair.flyer_a.central) {
        // A flight round a centre rounds many times over: 70 roundings of its distance were seen (pair 3068737)
        constexpr double k_round_centre = 8.0;
        reach += pair.flyer_a.state.position.norm() + 2.0 * central->centre.norm();
        reach += k_round_centre * (place_a.position - central->centre).norm();
        scatter = scatter_at(pair.a, pair.flyer_a, time);
        if (!is_wall && pair.flyer_b.central) scatter += scatter_at(pair.b, pair.flyer_b, time);
    }
    if (!is_wall) reach = std::max(reach, place_of(pair.b, pair.flyer_b, time).position.norm() + pair.b.radius);

    // Positions come from their states' moments: speed times time, and each factor rounds
    double travel = 0.0;
    for (const auto& [outline, flyer] : {std::pair(&pair.a, &pair.flyer_a), std::pair(&pair.b, &pair.flyer_b)}) {
        const double speed = std::max(velocity_of(*flyer, time).norm(), flyer->state.velocity.norm());
        travel += (speed + tip_speed(*outline, *flyer)) * (std::abs(time) + std::abs(flyer->state.time));
        if (outline->kind == Outline::Kind::rings) reach += outline->radius * std::abs(flyer->state.angle);
    }
    return k_epsilon * (16.0 * reach + 8.0 * travel) + 2.0 * scatter;
}

DenseAnswer search_densely(const FlyingPair& pair, double from, double until, const DenseOptions& options)
{
    constexpr long k_most_samples = 2'000'000;
    const double size = smaller_size(pair);
    const double floor = options.floor * size;
    const bool is_wall = pair.b.kind == Outline::Kind::wall;
    DenseAnswer answer;
    answer.least = k_infinity;
    double time = from;
    double time_before = from;
    double time_first = from;
    double gap_before = k_infinity;
    double gap_first = k_infinity;
    const auto overlaps = [&](double gap, double when) {
        if (gap < answer.least) {
            answer.least = gap;
            answer.least_time = when;
        }
        if (!(gap < 0.0) || gap >= -(options.depth * size + rounding_at(pair, when))) return false;
        answer.overlaps = true;
        answer.time = when;
        return true;
    };
    while (time < until) {
        if (++answer.samples > k_most_samples) {
            answer.gave_up = true;
            return answer;
        }
        const Approach approach = approach_of(pair, time);

        // While circles about the bodies are apart, turning doesn't matter
        const Place place_a = place_of(pair.a, pair.flyer_a, time);
        const Place place_b = place_of(pair.b, pair.flyer_b, time);
        const Vec2 between = place_a.position - place_b.position;
        const double apart = is_wall ? pair.b.normal.dot(place_a.position) - pair.b.offset - pair.a.radius
                                     : between.norm() - (pair.a.radius + pair.b.radius);
        if (apart > 0.05 * size) {
            gap_before = gap_first = k_infinity;
            const Vec2 relative = velocity_of(pair.flyer_a, time) - velocity_of(pair.flyer_b, time);
            const double leaving = is_wall ? pair.b.normal.dot(relative) : between.dot(relative);
            if (leaving >= 0.0 && approach.acceleration == 0.0) return answer;
            time += step_for(apart, approach.speed, approach);
            continue;
        }

        const double gap = gap_of(pair.a, place_a, pair.b, place_b);
        if (overlaps(gap, time)) return answer;
        if (gap_before <= floor && gap_before <= gap && gap_before <= gap_first) {
            double least_time = time;
            const double least = refine(pair, time_first, time, least_time, answer.samples);
            if (overlaps(least, least_time)) return answer;
        }
        time_first = time_before;
        gap_first = gap_before;
        time_before = time;
        gap_before = gap;
        const double step = step_for(std::max(gap, floor), approach.speed + approach.tips, approach);
        time = std::max(time + step, std::nextafter(time, k_infinity));
    }
    return answer;
}

double least_gap(const FlyingPair& pair, double from, double until, double& when)
{
    DenseAnswer answer = search_densely(pair, from, until);
    when = answer.least_time;
    if (answer.overlaps || answer.gave_up) return std::numeric_limits<double>::quiet_NaN();

    // The samples beside the least one are no farther off than its own step
    const Approach approach = approach_of(pair, when);
    const double step = step_for(std::max(answer.least, 1e-6 * smaller_size(pair)), approach.speed + approach.tips, approach);
    const double least = refine(pair, std::max(from, when - step), std::min(until, when + step), when, answer.samples);
    return std::min(least, answer.least);
}

} // namespace flying::stress
