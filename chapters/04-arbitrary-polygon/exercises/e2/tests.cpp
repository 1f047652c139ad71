#include <vector>

#include <doctest/doctest.h>

#include FLYING_ANSWER

using namespace flying;

TEST_CASE("a square of wire has a third of its mass times the square of its side")
{
    const WireMoments wire = wire_moments(std::vector<Vec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 0.5);
    CHECK(wire.mass == doctest::Approx(4.0).epsilon(1e-15));
    CHECK((wire.centroid - Vec2(1, 1)).norm() < 1e-15);
    CHECK(wire.moment_of_inertia == doctest::Approx(16.0 / 3.0).epsilon(1e-15));
}

TEST_CASE("corners without need change nothing, either way round")
{
    const WireMoments wire = wire_moments(std::vector<Vec2>{{0, 0}, {3, 0}, {0, 4}}, 1.0);
    const WireMoments more = wire_moments(std::vector<Vec2>{{0, 4}, {1.5, 2}, {3, 0}, {2, 0}, {1, 0}, {0, 0}}, 1.0);
    CHECK(wire.mass == doctest::Approx(12.0).epsilon(1e-15));
    CHECK(more.mass == doctest::Approx(wire.mass).epsilon(1e-15));
    CHECK((more.centroid - wire.centroid).norm() < 1e-15);
    CHECK(more.moment_of_inertia == doctest::Approx(wire.moment_of_inertia).epsilon(1e-14));
}

TEST_CASE("a wire far away is the same wire")
{
    const double far = 0x1p40;
    const WireMoments wire =
        wire_moments(std::vector<Vec2>{{far, far}, {far + 2, far}, {far + 2, far + 2}, {far, far + 2}}, 0.5);
    CHECK(wire.moment_of_inertia == doctest::Approx(16.0 / 3.0).epsilon(1e-15));
    CHECK((wire.centroid - Vec2(far + 1, far + 1)).norm() == 0.0);
}
