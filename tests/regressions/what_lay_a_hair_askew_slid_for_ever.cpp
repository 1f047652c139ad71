// A box that lay a hair askew, one corner a hair deep in the floor and the other a hair above it, slid on at 4e-8 m/s
// for ever, and never slept. Each step closed the open corner; the deep one was lifted; and since nothing paid for
// that, all of the step's way was taken back but the slide.

#include <doctest/doctest.h>

#include <cmath>

#include "chapters/support/lying_bodies.hpp"
#include "math/random.hpp"

using namespace flying;
using namespace flying::test;

TEST_CASE("a box that lies a hair askew and a hair deep sleeps within a second")
{
    Random random(31);
    for (int k = 0; k < 400; ++k) {
        CAPTURE(k);
        const double half = std::pow(10.0, random.uniform(-1.5, 1.0));
        const double askew = std::pow(10.0, random.uniform(-9.0, -6.0));
        const Material material{0.0, random.uniform(0.1, 1.2)};
        // One corner as deep as the tilt makes it, or less; the other open, or less deep
        const Vec2 place(0.0, half * (1.0 + askew * random.uniform(-1.0, 1.0)));
        RestBody body = box(2.0 * half, 2.0 * half, place, std::pow(10.0, random.uniform(-2.0, 3.0)), material);
        body.state.angle = k % 2 == 0 ? askew : -askew;
        body.state.velocity = Vec2(askew * half * random.uniform(-1.0, 1.0), 0.0);
        RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, material), body});
        while (!engine.is_asleep(1) && engine.time() < 1.0) engine.step();
        CHECK(engine.is_asleep(1));
        // It gets no further than it takes to close a corner; 7e-5 was the most
        CHECK(std::abs(engine.state(1).position.x()) < 1e-4 * half);
    }
}
