// A disc that rolled at 0.9 mm/s, and lay 27 nm deep in the floor, went on without turning: each step lifted it, which
// nothing paid for, and the limit of energy took back the lift, and the turn with it. Its motion along the floor had
// been thought to pay.

#include <doctest/doctest.h>

#include <cmath>

#include "chapters/support/lying_bodies.hpp"
#include "math/random.hpp"

using namespace flying;
using namespace flying::test;

TEST_CASE("a disc that rolls turns as far as it gets, however little it has sunk into the floor")
{
    Random random(7);
    for (int k = 0; k < 100; ++k) {
        CAPTURE(k);
        const double radius = std::pow(10.0, random.uniform(-1.0, 0.5));
        const double speed = std::pow(10.0, random.uniform(-3.5, -1.0));
        const double sunk = radius * std::pow(10.0, random.uniform(-9.0, -6.0));
        const Material material{random.uniform(0.0, 0.8), random.uniform(0.1, 1.2)};
        RestBody body = disc(radius, Vec2(0.0, radius - sunk), std::pow(10.0, random.uniform(-2.0, 3.0)), material);
        body.state.velocity = Vec2(speed, 0.0);
        body.state.spin = -speed / radius;
        RestEngine engine({wall(Vec2(0.0, 1.0), 0.0, material), body});
        // What it turns by as it is lifted, if anything pays for that, it may lose of its speed
        while (engine.time() < 0.5) engine.step();
        const BodyState old = engine.state(1);
        while (engine.time() < 1.0) engine.step();
        const BodyState now = engine.state(1);
        const double way = now.position.x() - old.position.x();
        CHECK(radius * (now.angle - old.angle) == doctest::Approx(-way).epsilon(1e-9));
    }
}
