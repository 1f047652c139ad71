#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include FLYING_ANSWER

namespace {

double distance(const Vec2& x, const Vec2& p, const Vec2& q)
{
    const Vec2 along = q - p;
    const double share = std::min(1.0, std::max(0.0, along.dot(x - p) / along.squaredNorm()));
    return (x - p - share * along).norm();
}

} // namespace

TEST_CASE("head on, at an end, past it, and along it")
{
    CHECK(first_touch(Vec2(0, 3), Vec2(0, -1), 1.0, Vec2(-5, 0), Vec2(5, 0)) == doctest::Approx(2.0));
    CHECK(first_touch(Vec2(0, -3), Vec2(0, 2), 1.0, Vec2(-5, 0), Vec2(5, 0)) == doctest::Approx(1.0));
    CHECK(first_touch(Vec2(-4, 0), Vec2(1, 0), 1.0, Vec2(0, 0), Vec2(5, 0)) == doctest::Approx(3.0));
    CHECK(std::isinf(first_touch(Vec2(-4, 2), Vec2(1, 0), 1.0, Vec2(0, 0), Vec2(5, 0))));
    CHECK(std::isinf(first_touch(Vec2(0, 3), Vec2(0, 1), 1.0, Vec2(-5, 0), Vec2(5, 0))));
}

TEST_CASE("no touch is missed and none is early")
{
    std::mt19937 random(17);
    std::uniform_real_distribution<double> any(-2.0, 2.0);
    int touched = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec2 p(any(random), any(random));
        const Vec2 q(any(random), any(random));
        const Vec2 x(3.0 * any(random), 3.0 * any(random));
        const Vec2 v(any(random), any(random));
        const double radius = 0.3;
        if ((q - p).norm() < 0.1 || distance(x, p, q) < radius + 1e-3) continue;
        const double time = first_touch(x, v, radius, p, q);
        if (std::isfinite(time)) {
            CHECK(std::abs(distance(x + time * v, p, q) - radius) < 1e-9);
            ++touched;
        }
        const double end = std::isfinite(time) ? time : 10.0;
        bool early = false;
        for (int i = 0; i < 200; ++i) early = early || distance(x + (end * i / 200.0) * v, p, q) < radius - 1e-9;
        CHECK_FALSE(early);
    }
    CHECK(touched > 100);
}
