// Two stars on a floor were pushed together, tip against tip. Once the tips lay in each other each was to leave over
// the side that it was nearest to, and these two sides look away from the same place: the pushes took turns, up and
// down, while the tips went through each other by half a size, at twenty seconds of computing for one.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "collide/separation.hpp"
#include "math/random.hpp"
#include "rest/outline_points.hpp"

using namespace flying;

namespace {

/// A star with so many tips.
///
/// inner  radius of its notches; that of the tips is 1 [m]
Polygon star(int tips, double inner)
{
    std::vector<Vec2> ring;
    for (int k = 0; k < 2 * tips; ++k) {
        const double angle = std::numbers::pi * k / tips;
        ring.push_back((k % 2 == 0 ? 1.0 : inner) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return Polygon({ring});
}

/// The lowest point of all that two stars' parts have.
Contact lowest_point(const Shape& shape, const CollisionShape& parts, const Pose& a, const Pose& b)
{
    const Outline outline(shape, parts);
    Contact lowest;
    lowest.separation = 1.0;
    const int count = static_cast<int>(parts.parts.size());
    for (int one = 0; one < count; ++one) {
        for (int two = 0; two < count; ++two) {
            const Manifold manifold = outline_points({outline, one, a}, {outline, two, b}, 0.01, 1e-12);
            for (int k = 0; k < manifold.count; ++k) {
                if (manifold.contacts[k].separation < lowest.separation) lowest = manifold.contacts[k];
            }
        }
    }
    return lowest;
}

} // namespace

TEST_CASE("two tips that lie in each other are told the shortest way apart")
{
    Random random(6151);
    for (const int tips : {4, 5, 7}) {
        const Shape shape = star(tips, tips == 4 ? 0.4 : 0.5);
        const CollisionShape parts = make_collision_shape(shape);
        const double half = std::acos(star(tips, tips == 4 ? 0.4 : 0.5).edges()[0].normal.dot(Vec2(0.0, 1.0)));
        int found = 0;
        for (int k = 0; k < 3000; ++k) {
            // One tip points along x, the other back, turned; and each has come past the other a little
            const double turn = random.uniform(-1.8, 1.8) * half;
            const double depth = random.uniform(1e-6, 0.05);
            const double way = std::numbers::pi + random.uniform(-2.0, 2.0) * half; // from the one tip to the other
            const Vec2 tip = Vec2(1.0, 0.0) + depth * Vec2(std::cos(way), std::sin(way));
            const double back = std::numbers::pi + turn;
            const Pose a{Vec2::Zero(), Rotation::of(0.0)};
            const Pose b{tip - Vec2(std::cos(back), std::sin(back)), Rotation::of(back)};
            // What lies between the rays that the two tips give, seen from one of them, is in both. They part over the
            // nearer of the outer rays
            const double low = std::numbers::pi - half + std::min(0.0, turn);
            const double high = std::numbers::pi + half + std::max(0.0, turn);
            if (way < low || way > high) continue;
            const double closed = -depth * std::min(std::sin(way - low), std::sin(high - way));
            if (closed > -1e-9 || high - low > 3.0) continue;
            const bool b_in_a = std::abs(way - std::numbers::pi) < half;
            const bool a_in_b = std::abs(way - back) < half;
            if (!b_in_a || !a_in_b) continue;
            ++found;
            CAPTURE(tips);
            CAPTURE(k);
            const Contact lowest = lowest_point(shape, parts, a, b);
            CHECK(lowest.separation == doctest::Approx(closed).epsilon(1e-9));
            const Pose moved{b.position - 1.0001 * lowest.separation * lowest.normal, b.rotation};
            CHECK(separation(parts, a, parts, moved) > -1e-9);
        }
        CHECK(found > 500);
    }
}
