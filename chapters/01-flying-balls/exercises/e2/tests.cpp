#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include FLYING_ANSWER

using flying::Vec2;

namespace {

Vec2 pull(const Vec2& x)
{
    const double r = x.norm();
    return -x / (r * r * r);
}

/// Once round the unit circle in n steps: where it ends.
PlaceAndVelocity round_the_circle(int n)
{
    PlaceAndVelocity b{Vec2(1.0, 0.0), Vec2(0.0, 1.0)};
    for (int k = 0; k < n; ++k) b = runge_kutta(b.x, b.v, pull, 2.0 * std::numbers::pi / n);
    return b;
}

double miss(int n)
{
    return (round_the_circle(n).x - Vec2(1.0, 0.0)).norm();
}

} // namespace

TEST_CASE("a thrown ball flies its parabola, for the acceleration doesn't change")
{
    const auto g = [](const Vec2&) { return Vec2(0.0, -8.0); };
    const PlaceAndVelocity b = runge_kutta(Vec2(0.0, 0.0), Vec2(3.0, 10.0), g, 1.25);
    CHECK((b.x - Vec2(3.75, 6.25)).norm() < 1e-14);
    CHECK((b.v - Vec2(3.0, 0.0)).norm() < 1e-14);
}

TEST_CASE("the error falls with the fourth power of the step")
{
    CHECK(std::abs(std::log2(miss(400) / miss(800)) - 4.0) < 0.1);
    CHECK(miss(200) < 1e-5);
}

TEST_CASE("the energy creeps all the same, by less than a millionth in a turn")
{
    const PlaceAndVelocity b = round_the_circle(100);
    const double drift = 0.5 * b.v.squaredNorm() - 1.0 / b.x.norm() + 0.5;
    CHECK(std::abs(drift) > 1e-9);
    CHECK(std::abs(drift) < 1e-6);
}
