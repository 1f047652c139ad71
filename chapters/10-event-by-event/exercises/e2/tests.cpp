#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>

#include FLYING_ANSWER

TEST_CASE("a million short steps after a very long time are a million short steps")
{
    for (const double scale : {0x1p-100, 1.0, 0x1p100}) {
        const Moment start{1e15 * scale, 0.0};
        const double dt = 0.001 * scale;
        Moment now = start;
        for (int k = 1; k <= 1'000'000; ++k) now = later(now, dt);
        CAPTURE(scale);
        // The offset is below a tenth of a second, and each step rounds it: 1e6 times 1e-17
        CHECK(std::abs(between(start, now) - 1e6 * dt) < 1e-10 * scale);
    }
}

TEST_CASE("a single step is kept to the last digit, and the order of moments shows")
{
    const Moment start{4e15, 0.0};
    const Moment next = later(start, 1e-6);
    CHECK(between(start, next) == 1e-6);
    CHECK(between(next, start) == -1e-6);
    CHECK(between(start, later(start, 0.0)) == 0.0);
}

TEST_CASE("long steps go into the epoch")
{
    const Moment start{1.0, 1e-20};
    const Moment end = later(start, 1e15);
    CHECK(end.epoch == 1e15 + 1.0);
    CHECK(std::abs(end.offset) <= 0.5);
    CHECK(between(start, end) == 1e15);
}
