#include <algorithm>
#include <array>

#include "live/pieces.hpp"
#include "math/random.hpp"
#include "orbits.hpp"
#include "walls.hpp"

// What this chapter's page computes.

namespace flying::live {

using namespace steps;

namespace {

enum class Method
{
    euler,
    symplectic,
    verlet
};

template <typename Acceleration>
Moving step_by(Method method, const Moving& b, const Acceleration& a, double h)
{
    if (method == Method::euler) return euler(b, a, h);
    if (method == Method::symplectic) return symplectic_euler(b, a, h);
    return verlet(b, a, h);
}

Method method_of(double number) { return static_cast<Method>(static_cast<int>(std::clamp(number, 0.0, 2.0))); }

/// velocity x, y, g, length of a step, method, until -> for each step: time, place by steps x, y, exact place x, y.
Answer toss(std::span<const double> of)
{
    const Vec2 g(0.0, -of[2]);
    const double h = of[3];
    const int count = static_cast<int>(std::clamp(of[5] / h, 1.0, 1e4));
    Moving b{Vec2::Zero(), Vec2(of[0], of[1])};
    BodyState start;
    start.velocity = b.v;
    Answer answer;
    for (int k = 0; k <= count; ++k) {
        const Vec2 exact = flight(start, g, k * h).position;
        answer.engine.insert(answer.engine.end(), {k * h, b.x.x(), b.x.y(), exact.x(), exact.y()});
        b = step_by(method_of(of[4]), b, [&](const Vec2&) { return g; }, h);
    }
    return answer;
}

/// count, g, share of the speeds, time -> energy of all at 1 kg each, without what turning holds; then for each ball:
/// radius, x, y, angle.
Answer box(std::span<const double> of)
{
    const int count = static_cast<int>(std::clamp(of[0], 1.0, 100.0));
    const Vec2 g(0.0, -of[1]);
    Random random(7);
    Answer answer{{0.0}, {}};
    for (int k = 0; k < count; ++k) {
        const double radius = random.uniform(0.12, 0.26);
        BodyState ball;
        ball.position = Vec2{random.uniform(0.4, 7.6), random.uniform(1.2, 4.0)};
        ball.velocity = of[2] * Vec2{random.uniform(-2.5, 2.5), random.uniform(-1.0, 2.0)};
        ball.spin = random.uniform(-4.0, 4.0);
        const BodyState now =
            walls::fly_between(ball, walls::box_walls(Vec2(0.0, 0.0), Vec2(8.0, 4.5), radius), g, of[3]);
        answer.engine.front() += 0.5 * now.velocity.squaredNorm() - g.dot(now.position);
        answer.engine.insert(answer.engine.end(), {radius, now.position.x(), now.position.y(), now.angle});
    }
    return answer;
}

/// eccentricity, steps a period, periods, method -> for each step: place by steps x, y, exact place x, y, and by how much
/// the energy is off, as a share of its size. The period first.
Answer orbit(std::span<const double> of)
{
    const Orbit orbit{1.0, 1.0, std::clamp(of[0], 0.0, 0.95)};
    const int a_period = static_cast<int>(std::clamp(of[1], 4.0, 1e4));
    const int count = static_cast<int>(std::clamp(of[2] * a_period, 1.0, 1e5));
    const double h = orbit.period() / a_period;
    const CentralPull pull{orbit.mu};
    Moving b = on_ellipse(orbit, 0.0);
    const double start = energy(b, orbit.mu);
    Answer answer{{orbit.period()}, {}};
    for (int k = 0; k <= count; ++k) {
        const Vec2 exact = on_ellipse(orbit, k * h).x;
        answer.engine.insert(answer.engine.end(), {b.x.x(), b.x.y(), exact.x(), exact.y(),
                                                   energy(b, orbit.mu) / start - 1.0});
        b = step_by(method_of(of[3]), b, pull, h);
    }
    return answer;
}

constexpr std::array k_pieces{Piece{"toss", 6, toss}, Piece{"box", 4, box}, Piece{"orbit", 4, orbit}};

} // namespace

std::span<const Piece> pieces_of_flight() { return k_pieces; }

} // namespace flying::live
