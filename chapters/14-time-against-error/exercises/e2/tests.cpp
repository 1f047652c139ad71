#include <cmath>
#include <doctest/doctest.h>

#include FLYING_ANSWER

using flying::work::Point;

TEST_CASE("at both ends it is the points' own time")
{
    const Point a{0.5, 1e-1};
    const Point b{8.0, 1e-3};
    CHECK(time_between(a, b, 1e-1) == doctest::Approx(0.5).epsilon(1e-14));
    CHECK(time_between(a, b, 1e-3) == doctest::Approx(8.0).epsilon(1e-13));
}

TEST_CASE("between them it follows the power law through both")
{
    for (const double p : {0.5, 1.0, 2.0, 4.0}) {
        const auto at = [p](double seconds) { return Point{seconds, 3.0 * std::pow(seconds, -p)}; };
        for (const double seconds : {1.1, 2.0, 5.0, 9.9}) {
            CHECK(time_between(at(1.0), at(10.0), at(seconds).error) == doctest::Approx(seconds).epsilon(1e-12));
            CHECK(time_between(at(10.0), at(1.0), at(seconds).error) == doctest::Approx(seconds).epsilon(1e-12));
        }
    }
}
