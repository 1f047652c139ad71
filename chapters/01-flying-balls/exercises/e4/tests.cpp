#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include FLYING_ANSWER

namespace {

/// Bounce by bounce.
double by_bounces(double y, double v, double g, double t)
{
    for (;;) {
        const double speed = std::sqrt(v * v + 2.0 * g * y);
        const double down = (v + speed) / g;
        if (down >= t) return y + v * t - 0.5 * g * t * t;
        t -= down;
        y = 0.0;
        v = speed;
    }
}

} // namespace

TEST_CASE("a throw before the first bounce is a parabola")
{
    CHECK(height_after(1.0, 2.0, 8.0, 0.25) == doctest::Approx(1.25));
    CHECK(height_after(1.0, -1.0, 8.0, 0.125) == doctest::Approx(0.8125));
}

TEST_CASE("bounce by bounce comes to the same")
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(0.1, 3.0);
    for (int k = 0; k < 1000; ++k) {
        const double y = any(random);
        const double v = any(random) - 1.5;
        const double t = 10.0 * any(random);
        CAPTURE(y);
        CAPTURE(v);
        CAPTURE(t);
        CHECK(std::abs(height_after(y, v, 9.81, t) - by_bounces(y, v, 9.81, t)) < 1e-10);
    }
}

TEST_CASE("after trillions of bounces the ball is where the period says")
{
    // From 1/16 m with g = 8: down in an eighth of a second, so the period is a quarter,
    // exact in doubles
    CHECK(height_after(0.0625, 0.0, 8.0, 0x1p40) == doctest::Approx(0.0625));
    CHECK(height_after(0.0625, 0.0, 8.0, 0x1p40 + 0.125) < 1e-7);
}
