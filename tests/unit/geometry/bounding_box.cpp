#include "geometry/aabb.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "math/random.hpp"

using namespace flying;

TEST_CASE("a disc's box reaches a radius to each side, however it is turned")
{
    const Aabb box = bounding_box(Disc{0.5}, {Vec2(3.0, -2.0), Rotation::of(1.0)});
    CHECK(box.min == Vec2(2.5, -2.5));
    CHECK(box.max == Vec2(3.5, -1.5));
}

TEST_CASE("a polygon's box holds every vertex, and one vertex lies on each of its sides")
{
    Random random(51);
    for (int k = 0; k < 500; ++k) {
        std::vector<Vec2> ring;
        const int count = 3 + random.below(9);
        for (int v = 0; v < count; ++v) ring.push_back(Vec2{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
        const Pose pose{Vec2{random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0)},
                        Rotation::of(random.uniform(-9.0, 9.0))};
        const Aabb box = bounding_box(Polygon({ring}), pose);
        bool left = false;
        bool right = false;
        bool low = false;
        bool high = false;
        for (const Vec2& vertex : ring) {
            const Vec2 point = pose * vertex;
            REQUIRE((point.x() >= box.min.x() && point.x() <= box.max.x()));
            REQUIRE((point.y() >= box.min.y() && point.y() <= box.max.y()));
            left = left || point.x() == box.min.x();
            right = right || point.x() == box.max.x();
            low = low || point.y() == box.min.y();
            high = high || point.y() == box.max.y();
        }
        REQUIRE((left && right && low && high));
    }
}

TEST_CASE("a half-plane's box has no end")
{
    const Aabb box = bounding_box(HalfPlane{}, {});
    CHECK(box.min.x() == -std::numeric_limits<double>::infinity());
    CHECK(box.max.y() == std::numeric_limits<double>::infinity());
}

TEST_CASE("boxes that share a side or a corner overlap, and others do not")
{
    const Aabb unit{Vec2(0.0, 0.0), Vec2(1.0, 1.0)};
    CHECK(overlap(unit, {Vec2(1.0, 1.0), Vec2(2.0, 2.0)}));
    CHECK(overlap(unit, {Vec2(-1.0, 0.25), Vec2(2.0, 0.5)})); // a bar across: no corner lies inside the other
    CHECK_FALSE(overlap(unit, {Vec2(std::nextafter(1.0, 2.0), 0.0), Vec2(2.0, 1.0)}));
    CHECK_FALSE(overlap(unit, {Vec2(0.0, -2.0), Vec2(1.0, -0.5)}));
}
