#include <doctest/doctest.h>

#include <vector>

#include "rest/rest_engine.hpp"
#include "world/make_shape.hpp"

// In each step in which a wall of 200 bricks that a ball had struck hardly moved, its impulses were looked for by eight
// systems of equations, and never found: sweeps went on from where they had been.

using namespace flying;

namespace {

RestBody of_mass(const Shape& shape, const Vec2& position, double mass, double moment)
{
    RestBody body{shape, {}, {1.0 / mass, 1.0 / moment}, {0.3, 0.4}};
    body.state.position = position;
    body.acceleration = Vec2(0.0, -9.81);
    return body;
}

/// Bricks in courses, every other one shifted by half a brick, and a ball that flies into them.
RestEngine wall_and_ball(int columns, int courses, double mass, double speed)
{
    RestBody floor{make_shape(RectangleDef{400.0, 1.0}).value(), {}, {}, {}, {0.3, 0.4}, true};
    floor.state.position = Vec2(0.0, -0.5);
    std::vector<RestBody> bodies{floor};
    const Shape brick = make_shape(RectangleDef{0.4, 0.2}).value();
    for (int k = 0; k < columns * courses; ++k) {
        const int course = k / columns;
        const Vec2 place(0.4 * (k % columns) + 0.2 * (course % 2), 0.2 * course + 0.1);
        bodies.push_back(of_mass(brick, place, 8.0, 8.0 * (0.16 + 0.04) / 12.0));
    }
    bodies.push_back(of_mass(Disc{0.25}, Vec2(-0.55, 0.1 * courses), mass, 0.5 * mass * 0.0625));
    bodies.back().state.velocity = Vec2(speed, 0.0);
    return RestEngine(bodies);
}

} // namespace

TEST_CASE("a wall that a ball shakes takes few systems of equations a step")
{
    struct Case
    {
        int columns;
        int courses;
        double mass;  // [kg]
        double speed; // [m/s]
    };
    for (const Case& each : {Case{20, 10, 50.0, 5.0}, Case{14, 8, 30.0, 6.0}, Case{10, 10, 20.0, 8.0}}) {
        RestEngine engine = wall_and_ball(each.columns, each.courses, each.mass, each.speed);
        engine.advance(2.0);
        CAPTURE(each.columns);
        // Two tell that no third would end it; in nearly half of 120 steps none does
        CHECK(engine.solve_counts().factorisations < 200);
    }
}
