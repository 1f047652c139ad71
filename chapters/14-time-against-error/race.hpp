#pragma once

#include <cmath>
#include <vector>

#include "../01-flying-balls/orbits.hpp"
#include "../01-flying-balls/steppers.hpp"
#include "../01-flying-balls/walls.hpp"
#include "precision.hpp"

/// A ball in a box, by steps and from wall to wall.
namespace flying::work {

// [work.by_steps]
/// n steps of length h. A wall in which a step finds the ball, on its way further in, turns it
/// round.
template <typename Step>
[[nodiscard]] BodyState by_steps(const Step& step, BodyState ball, const walls::Walls& walls, const Vec2& g, double h,
                                 long n)
{
    for (long k = 0; k < n; ++k) {
        const auto pull = [&](const Vec2&) { return g; };
        const steps::Moving next = step(steps::Moving{ball.position, ball.velocity}, pull, h);
        ball.position = next.x;
        ball.velocity = next.v;
        ball.time += h;
        for (const walls::Wall& wall : walls) {
            const bool is_in = wall.normal.dot(ball.position) < wall.offset;
            const bool goes_in = wall.normal.dot(ball.velocity) < 0.0;
            if (is_in && goes_in) ball.velocity = walls::reflected(ball.velocity, wall.normal);
        }
    }
    return ball;
}
// [work.by_steps]

// [work.by_walls]
/// The ball at a later time, and how many flights were computed until then.
struct Flown
{
    BodyState ball;
    long flights = 0;
};

[[nodiscard]] inline Flown by_walls(BodyState ball, const walls::Walls& walls, const Vec2& g, double time)
{
    for (long flights = 1;; ++flights) {
        const walls::Meeting next = walls::next_wall(ball, walls, g);
        if (!(ball.time + next.wait <= time)) return {flight(ball, g, time), flights};
        ball = flight(ball, g, ball.time + next.wait);
        ball.velocity = walls::reflected(ball.velocity, next.normal);
    }
}
// [work.by_walls]

// [work.truth]
/// Where a point is that started at x with velocity v between two walls: straight on, through
/// rooms that are mirrored one after the other.   [m]
[[nodiscard]] inline double unfolded(double x, double v, double t, double low, double high)
{
    const double width = high - low;
    const double way = std::fmod(x - low + v * t, 2.0 * width);
    const double round = way < 0.0 ? way + 2.0 * width : way;
    return low + std::min(round, 2.0 * width - round);
}

/// Height over the floor of an elastic ball let go at height h.   [m]
[[nodiscard]] inline double hop(double h, double g, double t)
{
    const double fall = std::sqrt(2.0 * h / g);
    const double since_top = std::fmod(t + fall, 2.0 * fall) - fall;
    return h - 0.5 * g * since_top * since_top;
}
// [work.truth]

/// The race of this chapter: a ball let go in a box, with a push to the side, and gravity.
struct Race
{
    double radius = 0.25; ///< [m]
    double width = 4.0;   ///< [m]
    double height = 1.5;  ///< of the ball's lowest point at the start [m]
    double g = 9.8;       ///< [m/s^2]
    double speed = 3.1;   ///< to the right [m/s]
    double until = 8.0;   ///< [s]

    [[nodiscard]] BodyState start() const { return {Vec2(1.0, radius + height), Vec2(speed, 0.0), 0.0, 0.0, 0.0}; }
    [[nodiscard]] walls::Walls walls() const { return walls::box_walls(Vec2(0.0, 0.0), Vec2(width, 4.0), radius); }
    [[nodiscard]] Vec2 gravity() const { return Vec2(0.0, -g); }
    [[nodiscard]] Vec2 truth(double t) const
    {
        return Vec2(unfolded(1.0, speed, t, radius, width - radius), radius + hop(height, g, t));
    }
    [[nodiscard]] double error(const BodyState& ball) const { return (ball.position - truth(until)).norm(); }
};

/// The error of a stepper at the end of the race.   [m]
template <typename Step>
[[nodiscard]] double error_by_steps(const Race& race, const Step& step, long n)
{
    return race.error(
        by_steps(step, race.start(), race.walls(), race.gravity(), race.until / static_cast<double>(n), n));
}

/// How far a stepper is off after one turn of an ellipse of eccentricity one half.   [m]
template <typename Step>
[[nodiscard]] double error_of_orbit(const Step& step, long n)
{
    const steps::Orbit orbit{40.0, 1.0, 0.5};
    const auto pull = [&](const Vec2& x) {
        const double r = x.norm();
        return Vec2((-orbit.mu / (r * r * r)) * x);
    };
    const steps::Moving start = on_ellipse(orbit, 0.0);
    const steps::Moving end = steps::run(step, start, pull, orbit.period() / static_cast<double>(n), n);
    return (end.x - start.x).norm();
}

} // namespace flying::work
