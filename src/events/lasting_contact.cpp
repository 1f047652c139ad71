#include "events/lasting_contact.hpp"

#include <algorithm>
#include <cmath>

namespace flying {
namespace {

/// [tolerances of touching] Hops that are no higher can't be told from contact.
constexpr double k_hop = 16.0;

/// [tolerances of touching] The same where nothing but friction shrinks them. It does so corner by corner, until hops
/// are so low that all corners come down as one, which costs nothing: of 200 polygons that were dropped, twelve hopped
/// on for ever like this, at 30 to 60 tolerances.
constexpr double k_flat_hop = 1024.0;

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
