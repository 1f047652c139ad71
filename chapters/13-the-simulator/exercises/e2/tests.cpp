#include <doctest/doctest.h>

#include FLYING_ANSWER

#include <bit>
#include <cmath>
#include <cstdint>

#include "math/random.hpp"

using namespace flying;

namespace {

bool same_bits(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

int digits_of(const std::string& text)
{
    int count = 0;
    bool leading = true;
    int zeros = 0;
    for (const char c : text) {
        if (c == 'e') break;
        if (c < '0' || c > '9') continue;
        leading = leading && c == '0';
        if (leading) continue;
        ++count;
        zeros = c == '0' ? zeros + 1 : 0;
    }
    return count - zeros;
}

} // namespace

TEST_CASE("every number comes back with its bits, and one digit fewer would not do")
{
    Random random(1351);
    for (int k = 0; k < 20'000; ++k) {
        const double size = std::ldexp(1.0, random.below(400) - 200);
        const double x = random.uniform(-1.0, 1.0) * size;
        const std::string text = shortest(x);
        CAPTURE(text);
        CAPTURE(x);
        CHECK(same_bits(std::strtod(text.c_str(), nullptr), x));
        const int digits = digits_of(text);
        if (digits < 2) continue;
        char shorter[400];
        std::snprintf(shorter, sizeof shorter, "%.*g", digits - 1, x);
        CHECK_FALSE(same_bits(std::strtod(shorter, nullptr), x));
    }
}

TEST_CASE("numbers that people type stay as they were typed")
{
    CHECK(shortest(0.1) == "0.1");
    CHECK(shortest(-9.81) == "-9.81");
    CHECK(shortest(3.0) == "3");
    CHECK(shortest(0.1 + 0.2) == "0.30000000000000004");
}

TEST_CASE("zero keeps its sign")
{
    CHECK(same_bits(std::strtod(shortest(-0.0).c_str(), nullptr), -0.0));
    CHECK(same_bits(std::strtod(shortest(0.0).c_str(), nullptr), 0.0));
}
