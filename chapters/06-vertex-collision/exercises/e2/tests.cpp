#include <doctest/doctest.h>

#include FLYING_ANSWER

using namespace flying;

TEST_CASE("a point in the middle is inside, points elsewhere are not")
{
    const std::array<Vec2, 3> triangle = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    CHECK(is_inside(Vec2(0.25, 0.25), triangle));
    CHECK_FALSE(is_inside(Vec2(0.75, 0.75), triangle));
    CHECK_FALSE(is_inside(Vec2(-0.25, 0.5), triangle));
    CHECK_FALSE(is_inside(Vec2(0.5, -0.25), triangle));
}

TEST_CASE("the boundary is not inside")
{
    const std::array<Vec2, 3> triangle = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    CHECK_FALSE(is_inside(Vec2(0.5, 0.5), triangle));
    CHECK_FALSE(is_inside(Vec2(0.5, 0.0), triangle));
    CHECK_FALSE(is_inside(Vec2(0, 0), triangle));
}

TEST_CASE("one step of a double beside the edge is seen")
{
    // The edge from (24, 24) to (12, 12) goes on through (0.5, 0.5); inside is above it
    const std::array<Vec2, 3> triangle = {Vec2(24, 24), Vec2(-24, 24), Vec2(-24, -24)};
    const double step = 0x1p-53;
    for (int k = 0; k < 64; ++k) {
        const double x = 0.5 + k * step;
        CAPTURE(k);
        CHECK_FALSE(is_inside(Vec2(x, x), triangle));
        CHECK(is_inside(Vec2(x, x + 2 * step), triangle));
        CHECK_FALSE(is_inside(Vec2(x + 2 * step, x), triangle));
    }
}
