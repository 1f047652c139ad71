#include "math/sine_cosine.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

#include "math/random.hpp"
#include "math/rotation.hpp"

using namespace flying;

namespace {

/// The oracle: a hundred digits, so that angles of 2^53 keep more than eighty after
/// reduction.
using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>>;

double ulp(double x)
{
    const double size = std::abs(x);
    return std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
}

/// Error of the worse of the two results.  [ulp]
double error_at(double angle)
{
    const SineCosine found = sine_cosine(angle);
    const Long sine = sin(Long(angle));
    const Long cosine = cos(Long(angle));
    const Long sine_error = abs(sine - Long(found.sine));
    const Long cosine_error = abs(cosine - Long(found.cosine));
    return std::max(static_cast<double>(sine_error) / ulp(static_cast<double>(sine)),
                    static_cast<double>(cosine_error) / ulp(static_cast<double>(cosine)));
}

std::uint64_t bits(double x)
{
    return std::bit_cast<std::uint64_t>(x);
}

} // namespace

TEST_CASE("two angles at once have the bits of one after the other")
{
    // Sizes on all sides of the bounds between the ways of reduction, and zeros, and multiples of pi/2
    Random random(12);
    const auto draw = [&] {
        const double size = std::ldexp(random.uniform(0.5, 1.0), static_cast<int>(random.uniform(-30.0, 55.0)));
        const double angle = random.uniform(0.0, 1.0) < 0.3 ? random.uniform(-20.0, 20.0) : size;
        const double quarters = std::floor(random.uniform(-9.0, 9.0)) * (0.5 * std::numbers::pi);
        const double choice = random.uniform(0.0, 1.0);
        return choice < 0.05 ? -0.0 : choice < 0.2 ? quarters : choice < 0.6 ? -angle : angle;
    };
    for (int k = 0; k < 100'000; ++k) {
        const double first = draw();
        const double second = draw();
        const std::array<SineCosine, 2> both = sine_cosine(first, second);
        const std::array<SineCosine, 2> each = {sine_cosine(first), sine_cosine(second)};
        for (std::size_t n = 0; n < 2; ++n) {
            REQUIRE(bits(both[n].sine) == bits(each[n].sine));
            REQUIRE(bits(both[n].cosine) == bits(each[n].cosine));
        }
    }
}

TEST_CASE("sine and cosine are within one unit in the last place at any size of the angle")
{
    // Half an ulp is the last rounding; the rest is that of the terms before
    struct Range
    {
        double low;
        double high;
    };
    const std::array<Range, 7> ranges = {
        {{-1000, -30}, {-30, -3}, {-3, 1}, {1, 10}, {10, 20}, {20, 40}, {40, 53}}};
    Random random(11);
    for (const Range& range : ranges) {
        CAPTURE(range.low);
        double worst = 0.0;
        for (int k = 0; k < 600; ++k) {
            const double size = std::exp2(random.uniform(range.low, range.high));
            worst = std::max(worst, error_at(k % 2 == 0 ? size : -size));
        }
        CHECK(worst < 0.8);
    }
}

TEST_CASE("the doubles nearest to multiples of pi/2 lose nothing either")
{
    // There one of the results is as small as the distance of the multiple from the double:
    // 2^-60 at the least
    const Long quarter = boost::math::constants::half_pi<Long>();
    Random random(12);
    double worst = 0.0;
    for (int k = 0; k < 3000; ++k) {
        const double count =
            k < 500 ? k + 1 : std::floor(std::exp2(random.uniform(1.0, 52.3)));
        worst = std::max(worst, error_at(static_cast<double>(Long(count) * quarter)));
    }
    CHECK(worst < 0.8);
}

TEST_CASE("angles at the seams between the ways of reduction are within one unit in the "
          "last place")
{
    for (const double seam :
         {std::numbers::pi / 4.0, 3.0 * std::numbers::pi / 4.0, 0x1p20, 0x1p53, 1e6}) {
        CAPTURE(seam);
        double angle = seam;
        for (int k = 0; k < 20; ++k) angle = std::nextafter(angle, 0.0);
        for (int k = 0; k < 40 && angle <= 0x1p53; ++k) {
            CHECK(error_at(angle) < 0.8);
            angle = std::nextafter(angle, std::numeric_limits<double>::infinity());
        }
    }
}

TEST_CASE("the sine is odd and the cosine even, to the bit")
{
    Random random(13);
    for (int k = 0; k < 100000; ++k) {
        const double angle = std::exp2(random.uniform(-1070.0, 53.0));
        const SineCosine there = sine_cosine(angle);
        const SineCosine back = sine_cosine(-angle);
        REQUIRE(bits(back.sine) == bits(-there.sine));
        REQUIRE(bits(back.cosine) == bits(there.cosine));
    }
}

TEST_CASE("no angle turns nothing")
{
    CHECK(bits(sine_cosine(0.0).sine) == bits(0.0));
    CHECK(bits(sine_cosine(-0.0).sine) == bits(-0.0));
    CHECK(sine_cosine(0.0).cosine == 1.0);
    CHECK(sine_cosine(5e-324).sine == 5e-324);
}

TEST_CASE("neither result leaves -1 ... 1, and their squares add up to one")
{
    Random random(14);
    for (int k = 0; k < 100000; ++k) {
        const SineCosine sc = sine_cosine(random.uniform(-1e6, 1e6));
        REQUIRE(std::abs(sc.sine) <= 1.0);
        REQUIRE(std::abs(sc.cosine) <= 1.0);
        REQUIRE(std::abs(sc.sine * sc.sine + sc.cosine * sc.cosine - 1.0) <= 4.0 * 0x1p-53);
    }
}

TEST_CASE("angles without a double's worth of meaning give NaN")
{
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double angle :
         {0x1.0000000000001p53, -1e300, infinity, -infinity, std::nan("")}) {
        CAPTURE(angle);
        CHECK(std::isnan(sine_cosine(angle).sine));
        CHECK(std::isnan(sine_cosine(angle).cosine));
    }
}

TEST_CASE("a turn and its inverse, and a sum of two turns, act as angles do")
{
    // One rounding of each of the four products and two sums: 4 ulp of the vector's length
    Random random(15);
    for (int k = 0; k < 1000; ++k) {
        const double alpha = random.uniform(-10.0, 10.0);
        const double beta = random.uniform(-10.0, 10.0);
        const Vec2 a{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
        const Rotation p = Rotation::of(alpha);
        const Rotation q = Rotation::of(beta);
        REQUIRE((inverse(p) * (p * a) - a).norm() <= 8.0 * 0x1p-53);
        REQUIRE(((p * q) * a - p * (q * a)).norm() <= 12.0 * 0x1p-53);

        const Long angle = Long(alpha) + Long(beta);
        const Rotation both = p * q;
        REQUIRE(std::abs(static_cast<double>(cos(angle)) - both.cosine) <= 8.0 * 0x1p-53);
        REQUIRE(std::abs(static_cast<double>(sin(angle)) - both.sine) <= 8.0 * 0x1p-53);
    }
}
