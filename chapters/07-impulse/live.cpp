#include <array>

#include "live/pieces.hpp"
#include "response/impact.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// mass of the ball, its speed along the rod, distance from the rod's middle, restitution, friction -> for a ball of
/// 0.1 m that flies up at 1 m/s against a resting rod of 1 kg and 1 m, 0.04 m thick: impulse on the rod along and across
/// the normal, velocity x, y and spin of the ball after, of the rod after, energy lost.
Answer strike(std::span<const double> of)
{
    constexpr double k_radius = 0.1;
    constexpr double k_thick = 0.04;
    const double m = of[0];
    const Inertia ball_inertia{1.0 / m, 1.0 / (0.5 * m * k_radius * k_radius)};
    const Inertia rod_inertia{1.0, 12.0 / (1.0 + k_thick * k_thick)};
    const ImpactBody ball{{of[1], 1.0}, 0.0, ball_inertia};
    const ImpactBody rod{{0.0, 0.0}, 0.0, rod_inertia};
    const ImpactPoint point{{0.0, k_radius}, {of[2], -0.5 * k_thick}, {0.0, 1.0}};
    const ImpactResult after = resolve_impact(ball, rod, {&point, 1}, {of[3], of[4]});
    const auto energy = [](const Vec2& velocity, double spin, const Inertia& inertia) {
        return 0.5 * velocity.squaredNorm() / inertia.inv_mass + 0.5 * spin * spin / inertia.inv_moment_of_inertia;
    };
    const double before = energy(ball.velocity, ball.spin, ball_inertia);
    const double left = energy(after.velocity_a, after.spin_a, ball_inertia) +
                        energy(after.velocity_b, after.spin_b, rod_inertia);
    return {{after.velocity_b.y() / rod_inertia.inv_mass, after.velocity_b.x() / rod_inertia.inv_mass,
             after.velocity_a.x(), after.velocity_a.y(), after.spin_a, after.velocity_b.x(), after.velocity_b.y(),
             after.spin_b, before - left},
            {}};
}

constexpr std::array k_pieces{Piece{"strike", 5, strike}};

} // namespace

std::span<const Piece> pieces_of_strikes() { return k_pieces; }

} // namespace flying::live
