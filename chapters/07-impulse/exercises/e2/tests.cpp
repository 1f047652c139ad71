#include <cmath>

#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "math/random.hpp"
#include "response/impact.hpp"

using namespace flying;

TEST_CASE("a disc bounces as the engine says")
{
    Random random(751);
    for (int k = 0; k < 1000; ++k) {
        const double mass = random.uniform(0.5, 2.0);
        const double radius = random.uniform(0.5, 2.0);
        const Disc disc{mass, radius, random.uniform(-3.0, 3.0), random.uniform(-1.0, 0.2), random.uniform(-2.0, 2.0)};
        const double e = random.uniform();
        const double mu = random.uniform();

        const ImpactBody body{{disc.v_x, disc.v_y}, disc.spin, {1.0 / mass, 2.0 / (mass * radius * radius)}};
        const ImpactPoint point{{0.0, 0.0}, {0.0, -radius}, {0.0, 1.0}};
        const ImpactResult after = resolve_impact({}, body, {&point, 1}, {e, mu});
        const Disc answer = bounce(disc, e, mu);

        CAPTURE(mass);
        CAPTURE(radius);
        CAPTURE(disc.v_x);
        CAPTURE(disc.v_y);
        CAPTURE(disc.spin);
        CAPTURE(e);
        CAPTURE(mu);

        // A dozen roundings of numbers up to 10
        CHECK(std::abs(answer.v_x - after.velocity_b.x()) < 1e-14);
        CHECK(std::abs(answer.v_y - after.velocity_b.y()) < 1e-14);
        CHECK(std::abs(answer.spin - after.spin_b) < 1e-14);
    }
}

TEST_CASE("a disc that rises is left alone")
{
    const Disc disc = bounce({1.0, 1.0, 3.0, 2.0, 0.5}, 0.5, 0.5);
    CHECK(disc.v_x == 3.0);
    CHECK(disc.v_y == 2.0);
    CHECK(disc.spin == 0.5);
}
