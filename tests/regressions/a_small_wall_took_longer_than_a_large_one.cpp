#include <doctest/doctest.h>

#include "support/wall_and_ball.hpp"

// A wall of 56 bricks that a ball hits took ten times as long as one of 70. Its forces were looked for by all that is
// known, for as long as anything in it moved: some hundred systems of equations a step, mostly in vain, where sweeps
// leave no more overlap. A heap of 64 that was poured into a box took four times as long as one of 72.

using namespace flying;
using namespace flying::testing;

TEST_CASE("a wall of 56 bricks that a ball hits needs few systems of equations a step")
{
    for (const double speed : {6.0, 8.0, 10.0}) {
        RestEngine engine = engine_of({7, 8, 80.0, speed, {0.0, 0.6}});
        engine.advance(1.0);
        CAPTURE(speed);
        // A short search takes eight, and a step that is made in halves has more than one
        CHECK(engine.solve_counts().factorisations <= 60 * 32);
        CHECK(engine.max_overlap() <= 0.01 * 0.2);
    }
}
