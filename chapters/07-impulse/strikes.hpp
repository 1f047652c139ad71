#pragma once

#include <array>

#include "response/impact.hpp"

namespace flying {


/// A ball that flies up at 1 m/s strikes a resting rod of 1 m and 1 kg.
/// ball_mass  [kg]; d  from the rod's middle, to the right [m]; e  restitution
inline ImpactResult strike_rod(double ball_mass, double d, double e)
{
    const double radius = 0.1;
    const double ball_moment = 0.5 * ball_mass * radius * radius;
    const ImpactBody ball{{0.0, 1.0}, 0.0, {1.0 / ball_mass, 1.0 / ball_moment}};
    const ImpactBody rod{{0.0, 0.0}, 0.0, {1.0, 12.0}};
    const ImpactPoint point{{0.0, radius}, {d, 0.0}, {0.0, 1.0}};
    return resolve_impact(ball, rod, {&point, 1}, {e, 0.0});
}



/// A disc of 1 m and 1 kg that strikes the floor at 1 m/s, sliding to the right, no spin.
/// slip  [m/s]
inline ImpactResult strike_floor(double slip, const Material& material)
{
    const ImpactBody floor{};
    const ImpactBody disc{{slip, -1.0}, 0.0, {1.0, 2.0}};
    const ImpactPoint point{{0.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}};
    return resolve_impact(floor, disc, {&point, 1}, material);
}


/// Velocities of five equal balls in a row.
using Row = std::array<double, 5>;


/// Each pair by itself, from the left to the right, until none approaches.
inline Row struck_in_turn(Row v, double e)
{
    const ImpactPoint point{{0.5, 0.0}, {-0.5, 0.0}, {1.0, 0.0}};
    for (bool any_push = true; any_push;) {
        any_push = false;
        for (int k = 0; k + 1 < 5; ++k) {
            const ImpactBody left{{v[k], 0.0}, 0.0, {1.0, 8.0}};
            const ImpactBody right{{v[k + 1], 0.0}, 0.0, {1.0, 8.0}};
            const ImpactResult after = resolve_impact(left, right, {&point, 1}, {e, 0.0});
            v[k] = after.velocity_a.x();
            v[k + 1] = after.velocity_b.x();
            any_push = any_push || after.any_push;
        }
    }
    return v;
}



/// All pairs together: (1 + e) times what brings the whole row to one velocity.
inline Row struck_at_once(Row v, double e)
{
    double common = 0.0;
    for (const double each : v) common += each / 5.0;
    for (double& each : v) each += (1.0 + e) * (common - each);
    return v;
}


} // namespace flying
