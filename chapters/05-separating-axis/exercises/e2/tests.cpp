#include <cmath>

#include <doctest/doctest.h>

#include FLYING_ANSWER

using namespace flying;

namespace {

Polygon square()
{
    return Polygon({{Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.5, 0.5), Vec2(-0.5, 0.5)}});
}

} // namespace

TEST_CASE("a square that overlaps another from the right leaves to the right, from above upwards")
{
    const Vec2 right = way_out(square(), {}, square(), {Vec2(0.75, 0.125), {}});
    CHECK(right.x() == doctest::Approx(0.25).epsilon(1e-14));
    CHECK(std::abs(right.y()) < 1e-14);
    const Vec2 up = way_out(square(), {}, square(), {Vec2(0.125, 0.75), {}});
    CHECK(std::abs(up.x()) < 1e-14);
    CHECK(up.y() == doctest::Approx(0.25).epsilon(1e-14));
}

TEST_CASE("squares that are apart stay")
{
    CHECK(way_out(square(), {}, square(), {Vec2(2.0, 0.0), {}}).norm() == 0.0);
}

TEST_CASE("wherever the best edge is, the way out ends the overlap, and half of it does not")
{
    for (int k = 0; k < 40; ++k) {
        const Pose pose_a = {Vec2(0.0, 0.0), Rotation::of(0.3 * k)};
        const Pose pose_b = {0.7 * (Rotation::of(0.7 * k) * Vec2(1.0, 0.0)), Rotation::of(-0.2 * k)};
        const Vec2 way = way_out(square(), pose_a, square(), pose_b);
        const auto after = [&](double part) {
            const Pose moved = {pose_b.position + part * way, pose_b.rotation};
            return greatest_separation(square(), square(), relative_pose(pose_a, moved)).separation;
        };
        CAPTURE(k);
        CHECK(after(1.0) == doctest::Approx(0.0).epsilon(1e-13));
        CHECK(after(0.5) < -1e-3);
    }
}
