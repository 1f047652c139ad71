#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include FLYING_ANSWER

using flying::MassProperties;

TEST_CASE("a nut of four sides without a hole is a square as wide as the wrench")
{
    const MassProperties nut = nut_mass(4, 2.0, 0.0, 3.0);
    CHECK(nut.mass == doctest::Approx(12.0).epsilon(1e-14));
    CHECK(nut.moment_of_inertia == doctest::Approx(8.0).epsilon(1e-14));
}

TEST_CASE("a nut of six sides weighs what is left of the hexagon")
{
    // A hexagon of wrench 2: side 2 / sqrt 3, area 2 sqrt 3, 5 m l^2 / 12
    const double area = 2.0 * std::sqrt(3.0);
    const double hole = 0.5;
    const MassProperties nut = nut_mass(6, 2.0, hole, 1.0);
    CHECK(nut.mass == doctest::Approx(area - std::numbers::pi * 0.25).epsilon(1e-14));
    const double expected = 5.0 * area * (4.0 / 3.0) / 12.0 - std::numbers::pi * std::pow(hole, 4) / 2.0;
    CHECK(nut.moment_of_inertia == doctest::Approx(expected).epsilon(1e-14));
}
