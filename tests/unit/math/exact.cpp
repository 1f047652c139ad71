#include "math/exact.hpp"

#include <cmath>

#include <boost/multiprecision/cpp_int.hpp>
#include <doctest/doctest.h>

#include "math/random.hpp"

using namespace flying;
using Rational = boost::multiprecision::cpp_rational;

TEST_CASE("by how much the square of a unit vector's length exceeds 1 is found to 75 bits")
{
    Random random(1);
    for (int k = 0; k < 20'000; ++k) {
        const double angle = random.uniform(-4.0, 4.0);
        const double far = std::pow(10.0, random.uniform(-300.0, 300.0));
        const double x = far * std::cos(angle);
        const double y = far * std::sin(angle) * (k % 7 == 0 ? 1e-9 : 1.0);
        const double length = std::hypot(x, y);
        const double n_x = x / length;
        const double n_y = y / length;
        const Rational exact = Rational(n_x) * Rational(n_x) + Rational(n_y) * Rational(n_y) - 1;
        const double off = (Rational(excess_of_unit(n_x, n_y)) - exact).convert_to<double>();
        REQUIRE(std::abs(off) <= 0x1p-75);
    }
    CHECK(excess_of_unit(1.0, 0.0) == 0.0);
    CHECK(excess_of_unit(0.0, -1.0) == 0.0);
    CHECK(excess_of_unit(-0.6, 0.8) != 0.0); // 0.6 and 0.8 are rounded
}
