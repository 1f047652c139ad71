// Of two stars that fell in a heap, the tip of one swung into an arm of the other by a quarter of a size within a step,
// and no contact was found: the end of a side beside that arm was nearer than the side by which the tip had come in, so
// it was to leave over that other side, before which it lay, not behind.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "math/random.hpp"
#include "rest/outline_points.hpp"

using namespace flying;

namespace {

/// A star of five tips, its arms thin enough that sides beside an arm end near it.
Polygon star()
{
    std::vector<Vec2> ring;
    for (int k = 0; k < 10; ++k) {
        const double angle = std::numbers::pi * k / 5.0;
        ring.push_back((k % 2 == 0 ? 0.38 : 0.171) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return Polygon({ring});
}

/// The lowest separation that is found of any two parts, or the margin.
double lowest(const Shape& shape, const CollisionShape& parts, const Pose& a, const Pose& b)
{
    const Outline outline(shape, parts);
    double least = 0.01;
    for (int one = 0; one < static_cast<int>(parts.parts.size()); ++one) {
        for (int two = 0; two < static_cast<int>(parts.parts.size()); ++two) {
            const Manifold manifold = outline_points({outline, one, a}, {outline, two, b}, 0.01, 1e-12);
            for (int k = 0; k < manifold.count; ++k) least = std::min(least, manifold.contacts[k].separation);
        }
    }
    return least;
}

} // namespace

TEST_CASE("the tip of a star that is in an arm of another is found there, deep or not")
{
    const Polygon polygon = star();
    const Shape shape = polygon;
    const CollisionShape parts = make_collision_shape(shape);
    const Outline outline(shape, parts);
    REQUIRE(parts.parts.size() > 1);
    Random random(4127);
    int found = 0;
    for (int k = 0; k < 20'000; ++k) {
        // The tip of B comes in over a side of an arm of A
        const int side = random.below(10);
        const Vec2& start = polygon.vertices()[side];
        const Vec2& finish = polygon.vertices()[(side + 1) % 10];
        const Vec2 along = (finish - start).normalized();
        const Vec2 out(along.y(), -along.x());
        const double depth = random.uniform(0.001, 0.12);
        const Vec2 tip = start + random.uniform() * (finish - start) - depth * out;
        const double angle = std::atan2(-out.y(), -out.x()) + random.uniform(-1.0, 1.0); // of the way of the tip
        const Pose a{Vec2::Zero(), Rotation::of(0.0)};
        const Pose b{tip - 0.38 * Vec2(std::cos(angle), std::sin(angle)), Rotation::of(angle)};
        // It may leave over another side that it looks at, if that is as near
        const auto is_near = [&](const Outline::Side& one) {
            const double to_it = one.normal.dot(tip - one.start);
            return to_it < 0.0 && one.normal.dot(out) > -0.5 && one.normal.dot(out) < 0.99 &&
                   one.distance_to(tip) < 1.25 * depth;
        };
        if (!outline.holds(tip, 1e-9)) continue;
        if (std::any_of(outline.sides().begin(), outline.sides().end(), is_near)) continue;
        ++found;
        CAPTURE(k);
        CHECK(lowest(shape, parts, a, b) < 0.0);
    }
    CHECK(found > 2000);
}
