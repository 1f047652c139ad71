#include <doctest/doctest.h>

#include "pendulum/small.hpp"

#include FLYING_ANSWER

TEST_CASE("the length gives back the period")
{
    CHECK(pendulum::small_period(length_of(2.0, 9.81), 9.81) == doctest::Approx(2.0).epsilon(1e-14));
}
