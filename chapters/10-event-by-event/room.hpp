#pragma once

#include <cmath>
#include <utility>

#include "balls.hpp"

namespace flying {

/// A room of 3 m by 2 m and a ball of 1/8 m in it. What matters is where its centre
/// can be.
struct Room
{
    double width = 2.75;                     ///< [m]
    double height = 1.75;                    ///< [m]
    Vec2 x = Vec2(0.575, 0.775);             ///< where the centre starts [m]
    Vec2 v = Vec2(1.0, 0.61803398874989485); ///< no bounce ever meets a corner [m/s]
};

/// The ball and its four walls.
inline EventEngine room_of(const Room& room)
{
    const double r = 0.125;
    std::vector<EventBody> bodies;
    bodies.push_back(ball(r, 1.0, room.x + Vec2(r, r), room.v));
    bodies.push_back(wall({1.0, 0.0}, 0.0));
    bodies.push_back(wall({-1.0, 0.0}, -(room.width + 2.0 * r)));
    bodies.push_back(wall({0.0, 1.0}, 0.0));
    bodies.push_back(wall({0.0, -1.0}, -(room.height + 2.0 * r)));
    return EventEngine(std::move(bodies), {PairFinder::all_pairs});
}

/// A place on an endless straight way, folded into [0, w] like a strip of paper.  [m]
inline double folded(double x, double w)
{
    const double turns = std::floor(x / w);
    const double rest = x - turns * w;
    return std::fmod(std::abs(turns), 2.0) == 0.0 ? rest : w - rest;
}

} // namespace flying
