#include "live/number_text_by_c.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include <doctest/doctest.h>

#include "math/number_text.hpp"
#include "math/random.hpp"

using namespace flying;

namespace {

/// Round ones, powers of two and what lies beside them, whatever a double can be, numbers of everyday size.
std::vector<double> numbers()
{
    std::vector<double> all = {0.0, -0.0, 1.0, 0.1, -2.5, 1e5, 123456.0, 1e15, 1e16, 1e22, 1e-4, 1e-5, 12345e-8, 5e-324};
    for (int exponent = -1074; exponent < 1024; ++exponent) {
        const double power = std::ldexp(1.0, exponent);
        all.insert(all.end(), {power, std::nextafter(power, 0.0), -std::nextafter(power, 1e308)});
    }
    Random random(3);
    for (int k = 0; k < 20000; ++k) {
        const double any = std::bit_cast<double>(random.bits());
        if (std::isfinite(any)) all.push_back(any);
        all.push_back(random.uniform(-100.0, 100.0));
        all.push_back(std::round(random.uniform(-1e6, 1e6)) / 1000.0);
    }
    return all;
}

} // namespace

TEST_CASE("a number as text reads back, and no shorter one does")
{
    for (const double x : numbers()) {
        const std::string text = by_c_library::number_text(x);
        CAPTURE(text);
        CHECK(std::bit_cast<std::uint64_t>(std::strtod(text.c_str(), nullptr)) == std::bit_cast<std::uint64_t>(x));
        // Where the library of this build has a shortest form of its own, it is as long
        CHECK(text.size() == number_text(x).size());
    }
}

TEST_CASE("the standard library and the C library write the same numbers")
{
    for (const double x : numbers()) {
        // Beyond 2^53 the standard library may give digits that the shortest form does not need
        if (std::abs(x) < 0x1p53) CHECK(by_c_library::number_text(x) == number_text(x));
        if (std::abs(x) < 0x1p53 && std::abs(x) > 1e-300) CHECK(by_c_library::plain_number_text(x) == plain_number_text(x));
        for (const int digits : {1, 3, 6, 17}) CHECK(by_c_library::rounded_text(x, digits) == rounded_text(x, digits));
    }
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double x : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
        CHECK(by_c_library::number_text(x) == number_text(x));
}
