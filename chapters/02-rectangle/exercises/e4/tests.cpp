#include <cmath>

#include <doctest/doctest.h>

#include FLYING_ANSWER

TEST_CASE("four quarters make a plate")
{
    const Plate plate =
        blocks_mass({{0.5, 0.25, 1, 0.5, 3}, {1.5, 0.25, 1, 0.5, 3}, {0.5, 0.75, 1, 0.5, 3}, {1.5, 0.75, 1, 0.5, 3}});
    CHECK(plate.mass == doctest::Approx(6.0));
    CHECK(plate.x == doctest::Approx(1.0));
    CHECK(plate.y == doctest::Approx(0.5));
    CHECK(plate.inertia == doctest::Approx(6.0 * 5.0 / 12.0));
}

TEST_CASE("a hole takes away")
{
    // A plate of 4 by 4 with a window of 1 by 1 at (1, 0): 15 kg, centre at -1/15
    const Plate plate = blocks_mass({{0, 0, 4, 4, 1}, {1, 0, 1, 1, -1}});
    CHECK(plate.mass == doctest::Approx(15.0));
    CHECK(plate.x == doctest::Approx(-1.0 / 15.0));
    CHECK(plate.inertia == doctest::Approx(16.0 * 32.0 / 12.0 - (1.0 / 6.0 + 1.0) - 15.0 / 225.0));
}

TEST_CASE("far away nothing changes")
{
    const Plate here = blocks_mass({{0, 0, 4, 4, 1}, {1, 0, 1, 1, -1}, {3, 1, 2, 1, 2}});
    const Plate there = blocks_mass({{1e5, 1e5, 4, 4, 1}, {1e5 + 1, 1e5, 1, 1, -1}, {1e5 + 3, 1e5 + 1, 2, 1, 2}});
    CHECK(there.mass == doctest::Approx(here.mass).epsilon(1e-14));
    CHECK(there.inertia == doctest::Approx(here.inertia).epsilon(1e-10));
    CHECK(std::abs(there.x - 1e5 - here.x) < 1e-10);
}
