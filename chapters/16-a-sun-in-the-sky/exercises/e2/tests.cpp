#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "../../../01-flying-balls/orbits.hpp"

#include FLYING_ANSWER

using namespace flying::steps;

TEST_CASE("the way from the nearest to the farthest point takes half a period")
{
    // At the ends the cosine hardly changes with the angle, which keeps half of its digits
    const Orbit o{2.0, 3.0, 0.4};
    CHECK(std::abs(time_at(o.mu, o.a, o.ecc, o.a * (1.0 - o.ecc))) < 1e-6);
    CHECK(std::abs(time_at(o.mu, o.a, o.ecc, o.a * (1.0 + o.ecc)) - 0.5 * o.period()) < 1e-6);
}

TEST_CASE("at the time that is found the body is at the distance that was asked for")
{
    for (const double ecc : {0.1, 0.5, 0.9}) {
        const Orbit o{1.0, 2.0, ecc};
        for (int k = 1; k < 10; ++k) {
            const double r = o.a * (1.0 - ecc + 0.2 * k * ecc);
            const double t = time_at(o.mu, o.a, ecc, r);
            CHECK(t < 0.5 * o.period());
            CHECK(std::abs(on_ellipse(o, t).x.norm() - r) < 1e-13 * o.a);
        }
    }
}

TEST_CASE("rounding at the two ends makes no time that is none")
{
    for (int k = 1; k < 200; ++k) {
        const double ecc = k / 200.0;
        CHECK(std::isfinite(time_at(1.0, 1.0, ecc, 1.0 - ecc)));
        CHECK(std::isfinite(time_at(1.0, 1.0, ecc, 1.0 + ecc)));
    }
}
