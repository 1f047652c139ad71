#include "math/orientation.hpp"

#include <array>
#include <cmath>

#include <boost/multiprecision/cpp_int.hpp>
#include <doctest/doctest.h>

#include "math/random.hpp"

using namespace flying;
using Rational = boost::multiprecision::cpp_rational;

namespace {

/// The oracle: the same determinant in exact rational numbers.
int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const Rational ux = Rational(a.x()) - Rational(c.x());
    const Rational uy = Rational(a.y()) - Rational(c.y());
    const Rational vx = Rational(b.x()) - Rational(c.x());
    const Rational vy = Rational(b.y()) - Rational(c.y());
    const Rational determinant = ux * vy - uy * vx;
    return (determinant > 0 ? 1 : 0) - (determinant < 0 ? 1 : 0);
}

/// A double with its last bits changed.
double nudged(Random& random, double x, int most)
{
    const int steps = random.below(2 * most + 1) - most;
    for (int k = 0; k < std::abs(steps); ++k) x = std::nextafter(x, steps > 0 ? 1e308 : -1e308);
    return x;
}

Vec2 random_point(Random& random, double size)
{
    return Vec2{random.uniform(-size, size), random.uniform(-size, size)};
}

} // namespace

TEST_CASE("left turns are positive, right turns negative, straight on is zero")
{
    CHECK(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)) == 1);
    CHECK(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(0, -1)) == -1);
    CHECK(orientation(Vec2(0, 0), Vec2(1, 1), Vec2(3, 3)) == 0);
    CHECK(orientation(Vec2(2, 5), Vec2(2, 5), Vec2(-1, 7)) == 0);
}

TEST_CASE("turns smaller than one are turns: the original kept them in an int")
{
    CHECK(orientation(Vec2(0, 0), Vec2(0.5, 0), Vec2(0.25, 0.5)) == 1);
    CHECK(orientation(Vec2(0, 0), Vec2(1e-6, 0), Vec2(0, -1e-6)) == -1);
}

TEST_CASE("points anywhere agree with exact rationals, at scales from 1e-6 to 1e6")
{
    Random random(61);
    for (int k = 0; k < 5000; ++k) {
        const double size = std::pow(10.0, random.below(13) - 6);
        const Vec2 a = random_point(random, size);
        const Vec2 b = random_point(random, size);
        const Vec2 c = random_point(random, size);
        REQUIRE(orientation(a, b, c) == exact_orientation(a, b, c));
    }
}

TEST_CASE("points next to one line agree with exact rationals")
{
    // The third point is computed on the line of the others, and all coordinates are then nudged by up to two last
    // places. Rounded arithmetic misjudges a large part of these
    Random random(62);
    int zeros = 0;
    int misjudged = 0;
    for (int k = 0; k < 20000; ++k) {
        const double size = std::exp2(random.uniform(-20.0, 20.0));
        Vec2 a = random_point(random, size);
        Vec2 b = random_point(random, size);
        const double share = random.below(17) / 8.0 - 0.5;
        Vec2 c = a + share * (b - a);
        for (Vec2* point : {&a, &b, &c}) *point = Vec2{nudged(random, point->x(), 2), nudged(random, point->y(), 2)};
        const int exact = exact_orientation(a, b, c);
        REQUIRE(orientation(a, b, c) == exact);
        zeros += exact == 0 ? 1 : 0;

        const double rounded = cross(a - c, b - c);
        misjudged += (rounded > 0.0 ? 1 : 0) - (rounded < 0.0 ? 1 : 0) != exact ? 1 : 0;
    }
    CHECK(zeros > 0);
    CHECK(misjudged > 0);
}

TEST_CASE("a grid of the smallest steps next to a line is judged as exact rationals judge it")
{
    // Kettner and others' picture (2008): points about (0.5, 0.5) against the line through (12, 12) and (24, 24)
    const double step = 0x1p-53;
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            const Vec2 a(0.5 + i * step, 0.5 + j * step);
            const int found = orientation(a, Vec2(12.0, 12.0), Vec2(24.0, 24.0));
            REQUIRE(found == exact_orientation(a, Vec2(12.0, 12.0), Vec2(24.0, 24.0)));
        }
    }
}

TEST_CASE("exponents may differ as far as 2^-480 and 2^500")
{
    Random random(63);
    for (int k = 0; k < 5000; ++k) {
        std::array<Vec2, 3> points;
        for (Vec2& point : points) {
            for (int axis = 0; axis < 2; ++axis) {
                const double size = std::exp2(random.uniform(-480.0, 500.0));
                point[axis] = random.below(8) == 0 ? 0.0 : std::copysign(size, random.uniform(-1.0, 1.0));
            }
        }
        if (k % 3 == 0) points[2] = points[0];
        if (k % 3 == 1) points[2] = 2.0 * points[1];
        REQUIRE(orientation(points[0], points[1], points[2]) == exact_orientation(points[0], points[1], points[2]));
    }
}

TEST_CASE("small triangles far away, and near-collinear ones at large and small scales")
{
    Random random(64);
    for (int k = 0; k < 5000; ++k) {
        const double scale = std::exp2(random.below(801) - 400);
        const Vec2 far = 1e15 * random_point(random, 1.0);
        const std::array<Vec2, 3> points = {far + random_point(random, 4.0), far + random_point(random, 4.0),
                                            far + random_point(random, 4.0)};
        const int exact = exact_orientation(points[0], points[1], points[2]);
        REQUIRE(orientation(points[0], points[1], points[2]) == exact);
        REQUIRE(orientation(scale * points[0], scale * points[1], scale * points[2]) == exact);
    }
}

TEST_CASE("turning the order round, mirroring, and exchanging two points act on the sign as they should")
{
    Random random(65);
    const auto mirror = [](const Vec2& p) { return Vec2(-p.x(), p.y()); };
    for (int k = 0; k < 5000; ++k) {
        const Vec2 a = random_point(random, 1.0);
        const Vec2 b = random_point(random, 1.0);
        const double share = random.uniform(-1.0, 2.0);
        const Vec2 c = a + share * (b - a);
        const int sign = orientation(a, b, c);
        REQUIRE(orientation(b, c, a) == sign);
        REQUIRE(orientation(c, a, b) == sign);
        REQUIRE(orientation(b, a, c) == -sign);
        REQUIRE(orientation(mirror(a), mirror(b), mirror(c)) == -sign);
        REQUIRE(orientation(perp(a), perp(b), perp(c)) == sign);
    }
}
