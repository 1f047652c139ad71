#include "rest/impact.hpp"

#include <algorithm>
#include <vector>

#include "response/impact.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {

/// A contact as the law of two bodies wants it: its place from both centres, from the arms of its pushes.
[[nodiscard]] ImpactPoint impact_point(const ContactPoint& c)
{
    const Vec2 n(c.n_x, c.n_y);
    const Vec2 t(-c.n_y, c.n_x);
    return {c.tangent_arm_a * n - c.normal_arm_a * t, c.tangent_arm_b * n - c.normal_arm_b * t, n};
}

[[nodiscard]] ImpactBody impact_body(const Mover& body)
{
    return {Vec2(body.v_x, body.v_y), body.spin, {body.inv_mass, body.inv_moment}};
}

void set_velocity(Mover& body, const Vec2& velocity, double spin)
{
    body.v_x = velocity.x();
    body.v_y = velocity.y();
    body.spin = spin;
}

} // namespace

int throw_back(std::span<Mover> velocities, std::span<const ContactPoint> points, std::span<const double> slowest)
{
    int impacts = 0;
    std::vector<ImpactPoint> of_pair;
    for (int round = 0; round < rest_tolerance::k_patience; ++round) {
        const int before = impacts;
        for (std::size_t first = 0, end = 0; first < points.size(); first = end) {
            // Find the points of the next two bodies, and whether one of them arrives
            const ContactPoint& pair = points[first];
            bool arrives = false;
            of_pair.clear();
            for (; end < points.size() && points[end].a == pair.a && points[end].b == pair.b; ++end) {
                const double u = normal_speed(points[end], velocities[pair.a], velocities[pair.b]);
                arrives = arrives || u < -slowest[end];
                of_pair.push_back(impact_point(points[end]));
            }
            if (!arrives) continue;

            // Strike
            Mover& a = velocities[pair.a];
            Mover& b = velocities[pair.b];
            const ImpactResult after =
                resolve_impact(impact_body(a), impact_body(b), of_pair, {pair.restitution, pair.friction});
            if (!after.any_push) continue;
            if (a.inv_mass > 0.0) set_velocity(a, after.velocity_a, after.spin_a);
            if (b.inv_mass > 0.0) set_velocity(b, after.velocity_b, after.spin_b);
            ++impacts;
        }
        if (impacts == before) break;
    }
    return impacts;
}

} // namespace flying
