#include <cmath>

#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "math/random.hpp"

TEST_CASE("from the middle it takes the radius over the speed")
{
    CHECK(time_to_rim(0, 0, 2, 0, 3) == 1.5);
    CHECK(time_to_rim(0, 0, 0, -4, 3) == 0.75);
    CHECK(std::isinf(time_to_rim(1, 1, 0, 0, 3)));
}

TEST_CASE("after the time found the centre is on the rim, and goes out")
{
    flying::Random random(1851);
    for (int k = 0; k < 1000; ++k) {
        const double x = random.uniform(-2.0, 2.0);
        const double y = random.uniform(-2.0, 2.0);
        const double vx = random.uniform(-3.0, 3.0);
        const double vy = random.uniform(-3.0, 3.0);
        const double t = time_to_rim(x, y, vx, vy, 3.0);
        CHECK(t > 0.0);
        CHECK(std::abs(std::hypot(x + t * vx, y + t * vy) - 3.0) < 1e-14);
        CHECK((x + t * vx) * vx + (y + t * vy) * vy > 0.0);
    }
}

TEST_CASE("a disc on the rim that comes in crosses the table")
{
    CHECK(std::abs(time_to_rim(3, 0, -1, 0, 3) - 6.0) < 1e-14);
    CHECK(std::abs(time_to_rim(3, 0, -1, 1, 3) - 3.0) < 1e-14);
    CHECK(time_to_rim(3, 0, 1, 0, 3) == 0.0);
}

TEST_CASE("close to the rim and on the way out, no digit is lost")
{
    // 2^-40 m are left, at 1 m/s
    CHECK(std::abs(time_to_rim(1.0 - 0x1p-40, 0, 1, 0, 1) - 0x1p-40) < 1e-24);

    // 2^-26 m are left, in any direction. The square of x is exact; no other product is
    flying::Random random(1852);
    const double x = 1.0 - 0x1p-26;
    for (int k = 0; k < 100; ++k) {
        const long double vx = random.uniform(0.5, 3.0);
        const long double vy = random.uniform(-3.0, 3.0);
        const long double inside = 1.0L - static_cast<long double>(x) * x;
        const long double root = std::sqrt(x * vx * x * vx + (vx * vx + vy * vy) * inside);
        const double expected = static_cast<double>(inside / (root + x * vx));
        const double found = time_to_rim(x, 0, static_cast<double>(vx), static_cast<double>(vy), 1);
        CHECK(std::abs(found / expected - 1.0) < 1e-12);
    }
}
