#include "events/lasting_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flying {
namespace {

/// [tolerances of touching] Hops that are no higher can't be told from contact.
constexpr double k_hop = 16.0;

/// [tolerances of touching] The same where nothing but friction shrinks them. It does so corner by corner, until hops
/// are so low that all corners come down as one, which costs nothing: of 200 polygons that were dropped, twelve hopped
/// on for ever like this, at 30 to 60 tolerances.
constexpr double k_flat_hop = 1024.0;

/// [radii] Ways between impacts that are no room.
constexpr double k_cramped = 0x1p-12;

/// [speeds] Where the field has changed a speed by less since the last impact, it hasn't brought the body back.
constexpr double k_by_field = 0x1p-4;

/// How fast A goes into B at a point.  [m/s]
[[nodiscard]] double approach_at(const BodyRows& bodies, int a, int b, const ImpactPoint& point)
{
    const Vec2 velocity_a = bodies[a].velocity + cross(bodies.sheet(a).spin, point.r_a);
    const Vec2 velocity_b = bodies[b].velocity + cross(bodies.sheet(b).spin, point.r_b);
    return point.normal.dot(velocity_a - velocity_b);
}

} // namespace

bool is_creeping(const BodyRows& bodies, int a, int b, const MeetingPoints& meeting)
{
    double press = std::max(bodies.pull_on(a).norm(), bodies.pull_on(b).norm());
    for (const int body : {a, b}) {
        const double spin = bodies.sheet(body).spin;
        if (spin != 0.0 && !bodies.is_fixed(body)) press += spin * spin * bodies[body].radius;
    }
    double approach = 0.0;
    for (const ImpactPoint& point : meeting.points) approach = std::max(approach, approach_at(bodies, a, b, point));
    return approach * approach <= 2.0 * press * (k_hop * meeting.touch);
}

TimeSinceImpact time_since_impact(const BodyRows& bodies, int a, int b, double time)
{
    const auto since = [&](int body) {
        return bodies.is_fixed(body) ? std::numeric_limits<double>::infinity() : time - bodies[body].time;
    };
    return {since(a), since(b)};
}

bool is_cramped(const BodyRows& bodies, int a, int b, const MeetingPoints& meeting, const TimeSinceImpact& since)
{
    // What hops comes back at half the speed that the field has changed by
    if (bodies.is_fixed(a) || bodies.is_fixed(b)) {
        double approach = 0.0;
        for (const ImpactPoint& point : meeting.points) approach = std::max(approach, approach_at(bodies, a, b, point));
        const double pull = std::max(bodies.pull_on(a).norm(), bodies.pull_on(b).norm());
        if (pull * since.last() > k_by_field * approach) return false;
    }

    // A smooth disc may spin as it likes
    const auto has_room = [&](int body, double time) {
        if (bodies.is_fixed(body)) return false;
        const BodyRows::Row& row = bodies[body];
        const double speed = row.kind == BodyRows::Kind::disc ? row.velocity.norm() : bodies.top_speed(body);
        const double radius = std::min(bodies.is_fixed(a) ? row.radius : bodies[a].radius,
                                       bodies.is_fixed(b) ? row.radius : bodies[b].radius);
        return speed * time > k_cramped * radius;
    };
    return !has_room(a, since.a) && !has_room(b, since.b);
}

int bounces_by_masses(const BodyRows& bodies)
{
    constexpr double k_bounces = 4.0; // pi, and some
    constexpr double k_most = 1e9;
    return static_cast<int>(std::min(k_bounces * std::sqrt(bodies.mass_ratio()), k_most));
}

bool stays(const BodyRows& bodies, int a, int b, const MeetingPoints& meeting)
{
    const Material both = combine(bodies.sheet(a).material, bodies.sheet(b).material);
    if (both.restitution == 1.0 && both.friction == 0.0) return false;
    const Vec2 pull = bodies.pull_on(a) - bodies.pull_on(b);
    const double hop = (both.restitution < 1.0 ? k_hop : k_flat_hop) * meeting.touch;
    return std::any_of(meeting.points.begin(), meeting.points.end(), [&](const ImpactPoint& point) {
        const double press = point.normal.dot(pull);
        const double approach = approach_at(bodies, a, b, point);
        return press > 0.0 && approach * approach <= 2.0 * press * hop;
    });
}

std::optional<double> end_of_bounces(const BodyRows& bodies, int a, int b, const MeetingPoints& meeting, double time,
                                     std::vector<Bounces>& bounces)
{
    // Only a disc on what never moves
    using Kind = BodyRows::Kind;
    const bool a_flies = !bodies.is_fixed(a);
    const BodyRows::Row& flyer = bodies[a_flies ? a : b];
    const BodyRows::Row& other = bodies[a_flies ? b : a];
    const double e = combine(bodies.sheet(a).material, bodies.sheet(b).material).restitution;
    if (flyer.kind != Kind::disc || other.kind != Kind::is_static || meeting.points.size() != 1 || e == 1.0) {
        bounces[bodies[a].id] = bounces[bodies[b].id] = {};
        return std::nullopt;
    }

    // Find the end, unless this is one of the bounces for which it is known
    const Vec2 into = a_flies ? meeting.points[0].normal : Vec2(-meeting.points[0].normal);
    const double press = bodies.acceleration().dot(into);
    const double leave = -flyer.velocity.dot(into);
    Bounces& known = bounces[flyer.id];
    if (press <= 0.0) {
        known = {};
        return std::nullopt;
    }
    const bool is_known = known.on == other.id && known.normal == into;
    if (!is_known) known = {other.id, into, time + 2.0 * leave / (press * (1.0 - e))};

    if (leave * leave > 2.0 * press * (k_hop * meeting.touch)) return std::nullopt;
    return known.end;
}

} // namespace flying
