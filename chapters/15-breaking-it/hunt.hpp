#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "math/random.hpp"
#include "math/vec2.hpp"

/// A hunt for a case that breaks something, and the smallest case that still does.
namespace flying::breaking {


/// A ball in a room one metre wide and high, and how it is moved.
struct Throw
{
    double x = 0.5;   ///< where it starts [m]
    double y = 0.5;
    double u = 0.0;   ///< its velocity [m/s]
    double v = 0.0;
    double g = 0.0;   ///< gravity, downwards [m/s^2]
    double e = 1.0;   ///< coefficient of restitution of the walls
    double h = 0.125; ///< the step [s]
    int steps = 1;
};



/// Where a ball is after a step, and how fast.
struct Ball
{
    Vec2 place = Vec2::Zero();
    Vec2 velocity = Vec2::Zero();
};

/// WRONG, as nearly everybody writes it at first: what is found beyond a wall is turned round.
inline void step_wrongly(Ball& ball, const Throw& how)
{
    ball.velocity.y() -= how.g * how.h;
    ball.place += how.h * ball.velocity;
    for (int axis = 0; axis < 2; ++axis) {
        if (ball.place[axis] < 0.0 || ball.place[axis] > 1.0) ball.velocity[axis] *= -how.e;
    }
}



/// What must hold of a run: true where it is broken.
using Oracle = std::function<bool(const Throw&)>;

/// True where the ball is outside the room after three steps running: a wall that turns it round needs one.
inline bool gets_out(const Throw& how)
{
    Ball ball{{how.x, how.y}, {how.u, how.v}};
    int outside = 0;
    for (int k = 0; k < how.steps; ++k) {
        step_wrongly(ball, how);
        const bool is_inside = ball.place.minCoeff() >= 0.0 && ball.place.maxCoeff() <= 1.0;
        outside = is_inside ? 0 : outside + 1;
        if (outside == 3) return true;
    }
    return false;
}

/// True where a ball that nothing pulls is ever faster than it was.
inline bool gains_energy(const Throw& how)
{
    Ball ball{{how.x, how.y}, {how.u, how.v}};
    const double start = ball.velocity.squaredNorm();
    for (int k = 0; k < how.steps; ++k) {
        step_wrongly(ball, how);
        if (ball.velocity.squaredNorm() > start) return true;
    }
    return false;
}



/// Case number `seed` of endlessly many.
inline Throw random_throw(std::uint64_t seed)
{
    Random random(seed);
    Throw how;
    how.x = random.uniform(0.1, 0.9);
    how.y = random.uniform(0.1, 0.9);
    how.u = random.uniform(-3.0, 3.0);
    how.v = random.uniform(-3.0, 3.0);
    how.g = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 10.0);
    how.e = random.below(2) == 0 ? 1.0 : random.uniform(0.2, 1.0);
    how.h = random.uniform(0.001, 0.02);
    how.steps = 1 + random.below(2000);
    return how;
}

/// The first seed, of so many, whose case breaks the oracle's promise.
inline std::optional<std::uint64_t> hunt(const Oracle& breaks, std::uint64_t most)
{
    for (std::uint64_t seed = 1; seed <= most; ++seed)
        if (breaks(random_throw(seed))) return seed;
    return std::nullopt;
}



/// The same number said more simply: nought, one, or with fewer digits.
inline std::array<double, 5> simpler(double value)
{
    const double tenth = std::round(10.0 * value) / 10.0;
    const double hundredth = std::round(100.0 * value) / 100.0;
    return {0.0, 1.0, 0.5, tenth, hundredth};
}

/// How many digits it takes to say a number, about.
inline int effort(double value)
{
    const auto options = std::array{0.0, 1.0, 0.5};
    for (std::size_t k = 0; k < options.size(); ++k)
        if (value == options[k]) return static_cast<int>(k);
    if (value == std::round(10.0 * value) / 10.0) return 3;
    return value == std::round(100.0 * value) / 100.0 ? 4 : 5;
}

/// The simplest case that can be reached from one that breaks, by making one number simpler at a time, such that each
/// case on the way breaks as well.
inline Throw shrink(Throw broken, const Oracle& breaks)
{
    for (bool went_on = true; went_on;) {
        went_on = false;
        const auto keep = [&](const Throw& candidate) {
            if (!breaks(candidate)) return false;
            broken = candidate;
            went_on = true;
            return true;
        };

        // Fewer steps first: every later try is then cheaper
        for (int fewer = broken.steps / 2; fewer > 0 && fewer < broken.steps; fewer += (broken.steps - fewer + 1) / 2) {
            Throw candidate = broken;
            candidate.steps = fewer;
            if (keep(candidate)) break;
        }
        for (double Throw::*number : {&Throw::u, &Throw::v, &Throw::g, &Throw::e, &Throw::x, &Throw::y, &Throw::h}) {
            for (const double value : simpler(broken.*number)) {
                Throw candidate = broken;
                candidate.*number = value;
                if (candidate.h <= 0.0 || effort(value) >= effort(broken.*number)) continue;
                if (keep(candidate)) break;
            }
        }
    }
    return broken;
}


} // namespace flying::breaking
