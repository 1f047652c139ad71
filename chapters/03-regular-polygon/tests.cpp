#include "regular_polygon.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

#include "geometry/moments.hpp"
#include "../02-rectangle/rectangle.hpp"
#include "math/sine_cosine.hpp"

using namespace flying;

namespace {

using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>>;

double relative(double found, double expected)
{
    return std::abs(found - expected) / std::abs(expected);
}

/// The formula as it is usually written, (m l^2 / 24)(1 + 3 cot^2(pi/n)), with sixty digits.
struct Expected60
{
    double mass;
    double moment_of_inertia;
};

Expected60 with_cotangent(int sides, double radius, double density)
{
    const Long angle = boost::math::constants::pi<Long>() / sides;
    const Long side = 2 * Long(radius) * sin(angle);
    const Long cotangent = cos(angle) / sin(angle);
    const Long mass = Long(density) * sides * side * side * cotangent / 4;
    const Long moment = mass * side * side / 24 * (1 + 3 * cotangent * cotangent);
    return {static_cast<double>(mass), static_cast<double>(moment)};
}

} // namespace

TEST_CASE("three sides are an equilateral triangle")
{
    // Sides R sqrt 3: mass sqrt 3 / 4 a^2, moment m (a^2 + b^2 + c^2) / 36 = m R^2 / 4
    const MassProperties triangle = regular_polygon_mass(3, 2.0, 5.0);
    CHECK(relative(triangle.mass, 5.0 * 3.0 * std::sqrt(3.0)) < 1e-15);
    CHECK(relative(triangle.moment_of_inertia, triangle.mass) < 1e-15);
}

TEST_CASE("four sides are a square")
{
    const MassProperties square = regular_polygon_mass(4, std::sqrt(2.0), 3.0);
    const MassProperties expected = rectangle_mass(2.0, 2.0, 3.0);
    CHECK(relative(square.mass, expected.mass) < 1e-15);
    CHECK(relative(square.moment_of_inertia, expected.moment_of_inertia) < 1e-15);
}

TEST_CASE("the stable form is the cotangent's, to a few roundings, for 3 to a billion sides")
{
    // pi/n, its sine, cosine and four products: 6 ulp
    for (const int sides : {3, 4, 5, 6, 7, 8, 12, 17, 100, 999, 12345, 1000000, 87654321, 1000000000, 2147483647}) {
        CAPTURE(sides);
        const MassProperties found = regular_polygon_mass(sides, 1.3, 0.7);
        const Expected60 expected = with_cotangent(sides, 1.3, 0.7);
        CHECK(relative(found.mass, expected.mass) < 6.0 * 0x1p-52);
        CHECK(relative(found.moment_of_inertia, expected.moment_of_inertia) < 6.0 * 0x1p-52);
    }
}

TEST_CASE("with more sides it becomes the disc, four times nearer for twice the sides")
{
    // m / m_disc = 1 - (2/3)(pi/n)^2 + ..., I/m / (R^2/2) = 1 - (2/3)(pi/n)^2 + ...
    const MassProperties disc = disc_mass(1.0, 1.0);
    double last_gap = 0.0;
    for (int sides = 64; sides <= 4096; sides *= 2) {
        const double gap = 1.0 - regular_polygon_mass(sides, 1.0, 1.0).moment_of_inertia / disc.moment_of_inertia;
        const double x = std::numbers::pi / sides;
        CHECK(relative(gap, 4.0 / 3.0 * x * x) < x * x);
        if (last_gap > 0.0) CHECK(relative(last_gap / gap, 4.0) < 4.0 * x * x);
        last_gap = gap;
    }
    const MassProperties million = regular_polygon_mass(1000000, 1.0, 1.0);
    CHECK(relative(million.mass, disc.mass) < 1e-11);
    CHECK(relative(million.moment_of_inertia, disc.moment_of_inertia) < 2e-11);
    CHECK(relative(regular_polygon_mass(1000000000, 1.0, 1.0).moment_of_inertia, disc.moment_of_inertia) < 1e-15);
}

TEST_CASE("signed triangles over the vertices give the same")
{
    // The vertices are rounded: 1 ulp of the radius each, which the sums take over
    for (const int sides : {3, 4, 5, 6, 7, 8, 31, 1000, 1000000}) {
        CAPTURE(sides);
        std::vector<Vec2> ring;
        for (int k = 0; k < sides; ++k) {
            const SineCosine sc = sine_cosine(2.0 * std::numbers::pi * k / sides);
            ring.push_back(1.7 * Vec2(sc.cosine, sc.sine));
        }
        const AreaMoments moments = moments_of_ring(ring);
        const MassProperties expected = regular_polygon_mass(sides, 1.7, 1.0);
        CHECK(relative(moments.area, expected.mass) < 8.0 * 0x1p-52);
        CHECK(relative(moments.second_moment, expected.moment_of_inertia) < 16.0 * 0x1p-52);
        CHECK(moments.centroid.norm() < 4.0 * 0x1p-52);
    }
}

TEST_CASE("radius and density scale by powers of two, to the bit")
{
    for (int sides = 3; sides < 200; ++sides) {
        const MassProperties plain = regular_polygon_mass(sides, 1.3, 0.7);
        const MassProperties scaled = regular_polygon_mass(sides, 0x1p100 * 1.3, 0x1p-90 * 0.7);
        REQUIRE(scaled.mass == 0x1p110 * plain.mass);
        REQUIRE(scaled.moment_of_inertia == 0x1p310 * plain.moment_of_inertia);
    }
}
