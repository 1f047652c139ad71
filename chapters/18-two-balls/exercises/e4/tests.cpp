#include <doctest/doctest.h>

#include FLYING_ANSWER

TEST_CASE("balls that part, and balls that meet once")
{
    CHECK(collide_row({{1, 1, -1}, {1, 2, 1}}, false) == 0);
    CHECK(collide_row({{1, 1, 1}, {1, 2, 0}}, false) == 1);
    CHECK(collide_row({{1, 1, 2}, {1, 2, 1}, {1, 3, 0}}, false) == 3); // equal balls only hand on their velocities
}

TEST_CASE("two balls and a wall count the digits of pi")
{
    CHECK(collide_row({{1, 1, 0}, {1, 2, -1}}, true) == 3);
    CHECK(collide_row({{1, 1, 0}, {100, 2, -1}}, true) == 31);
    CHECK(collide_row({{1, 1, 0}, {10000, 2, -1}}, true) == 314);
    CHECK(collide_row({{1, 1, 0}, {1000000, 2, -1}}, true) == 3141);
}

TEST_CASE("a cradle hands on one ball's velocity")
{
    CHECK(collide_row({{1, 0, 1}, {1, 1, 0}, {1, 2, 0}, {1, 3, 0}, {1, 4, 0}}, false) == 4);
}
