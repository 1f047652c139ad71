#include <cmath>

#include <doctest/doctest.h>

#include FLYING_ANSWER

TEST_CASE("squares, notches and stars drawn along their rim are simple")
{
    CHECK(is_simple({Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}));
    CHECK(is_simple({Vec2(0, 0), Vec2(3, 0), Vec2(3, 3), Vec2(2, 3), Vec2(2, 1), Vec2(1, 1), Vec2(1, 3), Vec2(0, 3)}));
    CHECK(is_simple({Vec2(0, 0), Vec2(1, 0), Vec2(2, 0), Vec2(2, 1)}));    // a corner within a straight side
    CHECK(is_simple({Vec2(0, 0), Vec2(0, -1), Vec2(0, -2), Vec2(1, -2)})); // and within an upright one
}

TEST_CASE("bow ties, touches and folds are not")
{
    CHECK_FALSE(is_simple({Vec2(0, 0), Vec2(1, 1), Vec2(1, 0), Vec2(0, 1)}));
    CHECK_FALSE(is_simple({Vec2(0, 0), Vec2(4, 0), Vec2(4, 2), Vec2(2, 0), Vec2(0, 2)})); // touches its lower side
    CHECK_FALSE(is_simple({Vec2(0, 0), Vec2(2, 0), Vec2(1, 0), Vec2(1, 1)}));             // folds back
    CHECK_FALSE(is_simple({Vec2(0, 0), Vec2(2, 0), Vec2(1, 0)})); // there is nothing but the fold
    CHECK_FALSE(is_simple({Vec2(0, 0), Vec2(1, 0)}));
}

TEST_CASE("the last digit decides")
{
    // A corner a hair above the line from (12, 12) to (24, 24), then a hair below it
    const double above = std::nextafter(0.5, 1.0);
    const double below = std::nextafter(0.5, 0.0);
    CHECK(is_simple({Vec2(0, 0), Vec2(24, 24), Vec2(12, 30), Vec2(0.5, above), Vec2(-1, 30)}));
    CHECK_FALSE(is_simple({Vec2(0, 0), Vec2(24, 24), Vec2(12, 30), Vec2(0.5, below), Vec2(-1, 30)}));
}
