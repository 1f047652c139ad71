#include "rest/impact.hpp"

#include <algorithm>
#include <vector>

#include "response/impacts_at_once.hpp"
#include "response/push_together.hpp"

namespace flying {
namespace {

/// A contact as the law of two bodies wants it: its place from both centres, from the arms of its pushes.
[[nodiscard]] ImpactPoint impact_point(const ContactPoint& c)
{
    const Vec2 n(c.n_x, c.n_y);
    const Vec2 t(-c.n_y, c.n_x);
    return {c.tangent_arm_a * n - c.normal_arm_a * t, c.tangent_arm_b * n - c.normal_arm_b * t, n};
}

/// Points as the law wants them, their pairs, and the bodies of these.
struct StruckBodies
{
    std::vector<ImpactPoint> places;
    std::vector<ImpactPair> pairs;
    std::vector<int> members; ///< by the numbers that pairs know them by
    std::vector<ImpactBody> bodies;

    StruckBodies(std::span<const Mover> velocities, std::span<const ContactPoint> points, double rests)
    {
        for (std::size_t k = 0; k < points.size(); ++k) {
            const ContactPoint& c = points[k];
            if (k == 0 || points[k - 1].a != c.a || points[k - 1].b != c.b)
                pairs.push_back({c.a, c.b, k, k, {c.restitution, c.friction}, rests});
            pairs.back().end = k + 1;
            places.push_back(impact_point(c));
        }
        members = number_anew(pairs);
        for (const int member : members) {
            const Mover& m = velocities[member];
            bodies.push_back({Vec2(m.v_x, m.v_y), m.spin, {m.inv_mass, m.inv_moment}});
        }
    }

    void hand_over(std::span<Mover> velocities) const
    {
        for (std::size_t k = 0; k < members.size(); ++k) {
            Mover& mover = velocities[members[k]];
            mover.v_x = bodies[k].velocity.x();
            mover.v_y = bodies[k].velocity.y();
            mover.spin = bodies[k].spin;
        }
    }
};

} // namespace

int throw_back(std::span<Mover> velocities, std::span<const ContactPoint> points, std::span<const double> slowest,
               double rests, int rounds)
{
    const auto arrives = [&](const ContactPoint& c) {
        return normal_speed(c, velocities[c.a], velocities[c.b]) < -slowest[&c - points.data()];
    };
    if (std::none_of(points.begin(), points.end(), arrives)) return 0;

    StruckBodies struck(velocities, points, rests);
    const int most = rounds * static_cast<int>(struck.pairs.size());
    const int impacts = resolve_impacts(struck.bodies, struck.pairs, struck.places, slowest, most);
    struck.hand_over(velocities);
    return impacts;
}

bool stop_at_once(std::span<Mover> velocities, std::span<const ContactPoint> points, double enough, int rounds)
{
    StruckBodies struck(velocities, points, 0.0);
    std::vector<double> bounds;
    for (const ContactPoint& c : points) bounds.push_back(c.bound);
    std::vector<PushTogether::Share> shares(struck.bodies.size());
    BlockSystem system;
    PushTogether together(struck.bodies, shares, system);
    for (const ImpactPair& pair : struck.pairs) together.add(pair, struck.places, bounds);
    if (!together.stop(enough, rounds)) return false;
    struck.hand_over(velocities);
    return true;
}

} // namespace flying
