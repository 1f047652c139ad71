#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/flight.hpp"

/// One disc in a box: flight until the next wall, reflection, flight again.
namespace flying::walls {


/// A straight wall as the disc's centre meets it: `normal` points into the room, and the
/// centre x turns round where normal . x = offset.
struct Wall
{
    Vec2 normal;   ///< of length 1
    double offset; ///< from the origin, the disc's radius added [m]
};

using Walls = std::array<Wall, 4>;

/// The four walls of a box, for a disc of radius R.
[[nodiscard]] inline Walls box_walls(const Vec2& min, const Vec2& max, double R)
{
    return {{{Vec2(1.0, 0.0), min.x() + R},
             {Vec2(-1.0, 0.0), R - max.x()},
             {Vec2(0.0, 1.0), min.y() + R},
             {Vec2(0.0, -1.0), R - max.y()}}};
}



/// How long until a way d is covered, at first at speed u, with acceleration c, all three
/// towards the wall. Infinity where the wall is never reached.   [s]
[[nodiscard]] inline double time_to_cover(double d, double u, double c)
{
    constexpr double k_never = std::numeric_limits<double>::infinity();
    const double square = u * u + 2.0 * c * d;
    if (square < 0.0) return k_never; // turns round before the wall
    if (u > 0.0) return 2.0 * d / (u + std::sqrt(square));
    return c > 0.0 ? (std::sqrt(square) - u) / c : k_never;
}



/// The velocity after a wall with normal n: its part along n turns round, nothing is lost.
[[nodiscard]] inline Vec2 reflected(const Vec2& v, const Vec2& n)
{
    return v - 2.0 * v.dot(n) * n;
}



/// A wall that is going to be met.
struct Meeting
{
    double wait = std::numeric_limits<double>::infinity(); ///< [s]
    Vec2 normal = Vec2::Zero();                            ///< of the wall
};

/// The wall that a disc meets first.
[[nodiscard]] inline Meeting next_wall(const BodyState& disc, const Walls& walls, const Vec2& g)
{
    Meeting next;
    for (const Wall& wall : walls) {
        const double d = std::max(0.0, wall.normal.dot(disc.position) - wall.offset);
        const double u = -wall.normal.dot(disc.velocity);
        const double t = time_to_cover(d, u, -wall.normal.dot(g));
        if (t < next.wait) next = {t, wall.normal};
    }
    return next;
}



/// The disc at a later time, after as many walls as come in its way. Not for one that lies
/// still.
[[nodiscard]] inline BodyState fly_between(BodyState disc, const Walls& walls,
                                           const Vec2& g, double time)
{
    for (;;) {
        const Meeting next = next_wall(disc, walls, g);
        if (!(disc.time + next.wait <= time)) return flight(disc, g, time);

        // Fly there and turn round
        disc = flight(disc, g, disc.time + next.wait);
        disc.velocity = reflected(disc.velocity, next.normal);
    }
}


} // namespace flying::walls
