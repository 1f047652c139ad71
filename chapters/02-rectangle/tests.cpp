#include "rectangle.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "math/random.hpp"

using namespace flying;

namespace {

double relative(double found, double expected)
{
    return std::abs(found - expected) / std::abs(expected);
}

/// Integral of x^2 + y^2 over a rectangle about the origin, by Gauss's rule of two points in each of n x n cells: exact
/// for cubics, so that only rounding is left.
double integrated_second_moment(double width, double height, int n)
{
    const double cell_x = width / n;
    const double cell_y = height / n;
    const double shift = 0.5 / std::sqrt(3.0);
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            for (const double sx : {-shift, shift}) {
                for (const double sy : {-shift, shift}) {
                    const double x = -0.5 * width + (i + 0.5 + sx) * cell_x;
                    const double y = -0.5 * height + (j + 0.5 + sy) * cell_y;
                    sum += (x * x + y * y) * (0.25 * cell_x * cell_y);
                }
            }
        }
    }
    return sum;
}

} // namespace

TEST_CASE("a square of side 1 and mass 1 has a sixth")
{
    const MassProperties square = rectangle_mass(1.0, 1.0, 1.0);
    CHECK(square.mass == 1.0);
    CHECK(square.moment_of_inertia == doctest::Approx(1.0 / 6.0).epsilon(1e-15));
}

TEST_CASE("a door of 1 m by 2 m turns four times as hard about its hinge as about its middle line")
{
    // About the line through the middle: m w^2 / 12. The hinge lies half a width away: m w^2 / 3. In the plane of the
    // door's floor plan it is a thin rod of length w
    const double thickness = 1e-9;
    const MassProperties plan = rectangle_mass(1.0, thickness, 20.0 / thickness);
    CHECK(relative(plan.mass, 20.0) < 1e-15);
    CHECK(relative(plan.moment_of_inertia, 20.0 / 12.0) < 1e-15);
    CHECK(relative(about_parallel_axis(plan, 0.5), 20.0 / 3.0) < 1e-15);
}

TEST_CASE("a rectangle's moment of inertia is the integral of the squared distance")
{
    // 4 n^2 terms of one sign, each of a few roundings
    Random random(31);
    for (int k = 0; k < 100; ++k) {
        const double width = std::exp2(random.uniform(-5.0, 5.0));
        const double height = std::exp2(random.uniform(-5.0, 5.0));
        const double density = std::exp2(random.uniform(-5.0, 5.0));
        const double expected = density * integrated_second_moment(width, height, 8);
        CHECK(relative(rectangle_mass(width, height, density).moment_of_inertia, expected) < 1e-13);
    }
}

TEST_CASE("a second moment of area is not a moment of inertia: its unit gives it away")
{
    // With twice the density the moment of inertia doubles, at the same shape; an area's would not
    const MassProperties light = rectangle_mass(2.0, 3.0, 1.0);
    const MassProperties heavy = rectangle_mass(2.0, 3.0, 2.0);
    CHECK(heavy.moment_of_inertia == 2.0 * light.moment_of_inertia);
    CHECK(light.moment_of_inertia == doctest::Approx(6.0 * 13.0 / 12.0).epsilon(1e-15));
}

// [rectangle.tests.quarters]
TEST_CASE("four quarters, each moved by parallel axes, make the rectangle")
{
    Random random(32);
    for (int k = 0; k < 200; ++k) {
        const double width = std::exp2(random.uniform(-10.0, 10.0));
        const double height = std::exp2(random.uniform(-10.0, 10.0));
        const MassProperties quarter = rectangle_mass(0.5 * width, 0.5 * height, 3.0);
        const double distance = 0.25 * std::hypot(width, height);
        const double together = 4.0 * about_parallel_axis(quarter, distance);
        CHECK(relative(together, rectangle_mass(width, height, 3.0).moment_of_inertia) <
              1e-15);
    }
}
// [rectangle.tests.quarters]

TEST_CASE("unequal strips make the rectangle too")
{
    // Strips of 1, 2, 3 and 4 tenths of the height
    const double width = 0.7;
    const double height = 1.9;
    double sum = 0.0;
    double below = 0.0;
    for (const double share : {0.1, 0.2, 0.3, 0.4}) {
        const double middle = (below + 0.5 * share - 0.5) * height;
        sum += about_parallel_axis(rectangle_mass(width, share * height, 2.5), middle);
        below += share;
    }
    CHECK(relative(sum, rectangle_mass(width, height, 2.5).moment_of_inertia) < 1e-14);
}

TEST_CASE("the sides may be swapped to the bit")
{
    Random random(33);
    for (int k = 0; k < 1000; ++k) {
        const double width = std::exp2(random.uniform(-10.0, 10.0));
        const double height = std::exp2(random.uniform(-10.0, 10.0));
        REQUIRE(rectangle_mass(width, height, 1.7).moment_of_inertia ==
                rectangle_mass(height, width, 1.7).moment_of_inertia);
    }
}

TEST_CASE("a disc is the sum of thin rings, each of the moment m r squared")
{
    // The integral of 2 pi r r^2 from 0 to R by Simpson's rule, exact for cubics
    Random random(34);
    for (int k = 0; k < 100; ++k) {
        const double radius = std::exp2(random.uniform(-10.0, 10.0));
        const double half = 0.5 * radius;
        const double ends = std::numbers::pi * 2.0 * (4.0 * half * half * half + radius * radius * radius);
        const MassProperties disc = disc_mass(radius, 2.0);
        CHECK(relative(disc.moment_of_inertia, 2.0 * ends * radius / 6.0) < 1e-15);
        CHECK(relative(disc.mass, 2.0 * std::numbers::pi * radius * radius) < 1e-15);
    }
}

TEST_CASE("an annulus and the disc in its hole make the whole disc")
{
    Random random(35);
    for (int k = 0; k < 200; ++k) {
        const double outer = std::exp2(random.uniform(-10.0, 10.0));
        const double inner = random.uniform(0.0, outer);
        const MassProperties whole = disc_mass(outer, 1.0);
        const MassProperties ring = annulus_mass(inner, outer, 1.0);
        const MassProperties hole = disc_mass(inner, 1.0);
        CHECK(relative(ring.mass + hole.mass, whole.mass) < 1e-15);
        CHECK(relative(ring.moment_of_inertia + hole.moment_of_inertia, whole.moment_of_inertia) < 2e-15);
    }
    CHECK(annulus_mass(0.0, 2.0, 1.0).moment_of_inertia == disc_mass(2.0, 1.0).moment_of_inertia);
}

TEST_CASE("a ring as thin as a rounding or two keeps its mass")
{
    // R - r is exact between neighbours; pi (R^2 - r^2) by squares would lose every digit
    const double outer = 1.0 + 8.0 * 0x1p-52;
    const double inner = 1.0;
    const MassProperties ring = annulus_mass(inner, outer, 1.0);
    CHECK(relative(ring.mass, 2.0 * std::numbers::pi * (8.0 * 0x1p-52)) < 1e-14);
    CHECK(relative(ring.moment_of_inertia / ring.mass, 1.0) < 1e-14);
}

TEST_CASE("lengths and densities scale by powers of two, to the bit")
{
    Random random(36);
    for (int k = 0; k < 1000; ++k) {
        const double a = random.uniform(0.1, 1.0);
        const double b = random.uniform(1.0, 2.0);
        const double density = random.uniform(0.5, 2.0);
        const double length = std::exp2(random.below(201) - 100);
        const double thick = std::exp2(random.below(201) - 100);
        const std::array<MassProperties, 3> plain = {rectangle_mass(a, b, density), disc_mass(b, density),
                                                     annulus_mass(a, b, density)};
        const std::array<MassProperties, 3> scaled = {rectangle_mass(length * a, length * b, thick * density),
                                                      disc_mass(length * b, thick * density),
                                                      annulus_mass(length * a, length * b, thick * density)};
        for (std::size_t s = 0; s < plain.size(); ++s) {
            REQUIRE(scaled[s].mass == thick * length * length * plain[s].mass);
            REQUIRE(scaled[s].moment_of_inertia ==
                    thick * length * length * length * length * plain[s].moment_of_inertia);
        }
    }
}
