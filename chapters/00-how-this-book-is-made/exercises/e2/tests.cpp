#include <initializer_list>

#include <doctest/doctest.h>

#include FLYING_ANSWER

TEST_CASE("the speed of the middle makes no error but rounding")
{
    for (const int steps : {1, 3, 10, 100}) {
        CAPTURE(steps);
        CHECK(fall_by_middle(9.81, 2.0, steps) == doctest::Approx(19.62).epsilon(1e-12));
    }
}

TEST_CASE("no time, no way")
{
    CHECK(fall_by_middle(9.81, 0.0, 5) == 0.0);
}
