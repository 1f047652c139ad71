#pragma once

#include <vector>

#include "rest/rest_engine.hpp"
#include "world/make_shape.hpp"

namespace flying::testing {

/// A wall of bricks of 0.4 m by 0.2 m and 8 kg, and a ball of 0.25 m that flies into its middle.
struct WallAndBall
{
    int columns;
    int courses;       ///< every other one is shifted by half a brick
    double mass;       ///< of the ball [kg]
    double speed;      ///< of the ball [m/s]
    Material material; ///< of bricks and ball; the floor has e = 1 and mu = 0
};

inline RestEngine engine_of(const WallAndBall& wall)
{
    RestBody floor{make_shape(RectangleDef{100.0, 1.0}).value(), {}, {}, {}, Vec2::Zero(), true};
    floor.state.position = Vec2(0.0, -0.5);
    std::vector<RestBody> bodies{floor};
    const auto add = [&](const Shape& shape, const Vec2& place, double mass, double moment) {
        RestBody& body = bodies.emplace_back(RestBody{shape, {}, {1.0 / mass, 1.0 / moment}, wall.material});
        body.state.position = place;
        body.acceleration = Vec2(0.0, -9.81);
    };
    const Shape brick = make_shape(RectangleDef{0.4, 0.2}).value();
    for (int k = 0; k < wall.columns * wall.courses; ++k) {
        const int course = k / wall.columns;
        const Vec2 place(0.4 * (k % wall.columns) + 0.2 * (course % 2), 0.2 * course + 0.1);
        add(brick, place, 8.0, 8.0 * (0.16 + 0.04) / 12.0);
    }
    add(Disc{0.25}, Vec2(-0.55, 0.1 * wall.courses), wall.mass, 0.5 * wall.mass * 0.0625);
    bodies.back().state.velocity = Vec2(wall.speed, 0.0);
    return RestEngine(bodies);
}

} // namespace flying::testing
