#include "live/number_text_by_c.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "math/number_text.hpp"

namespace flying {

namespace {

constexpr int k_most_digits = std::numeric_limits<double>::max_digits10;

/// sign 0.digits * 10^point
struct Decimal
{
    bool is_negative = false;
    std::string digits; ///< without zeros at the end, but "0" itself
    int point = 0;
};

std::string printed(const char* format, int digits, double x)
{
    char text[40];
    std::snprintf(text, sizeof text, format, digits, x);
    return text;
}

bool reads_back(const std::string& text, double x)
{
    return std::strtod(text.c_str(), nullptr) == x;
}

/// The next number of as many digits away from zero, of "d.ddde+xx" whose last digit is no nine.
std::string next_outwards(std::string text)
{
    char& last = text[text.find('e') - 1];
    if (last != '9') ++last;
    return text;
}

/// The shortest that reads back, of a finite number.
Decimal shortest(double x)
{
    // Whatever has fifteen digits comes through a double, so only what isn't normal can do with fewer than those are
    const bool is_normal = x == 0.0 || std::isnormal(x);
    std::string text;
    for (int digits = is_normal ? std::numeric_limits<double>::digits10 : 1; digits <= k_most_digits; ++digits) {
        text = printed("%.*e", digits - 1, x);
        if (reads_back(text, x)) break;
        // Outwards of a power of two the numbers lie farther apart than inwards: what is not nearest may still read back
        text = next_outwards(text);
        if (reads_back(text, x)) break;
    }

    Decimal out;
    const std::size_t exponent = text.find('e');
    for (const char c : text.substr(0, exponent)) {
        if (c == '-') out.is_negative = true;
        if (c >= '0' && c <= '9') out.digits += c;
    }
    out.digits.resize(std::max<std::size_t>(1, out.digits.find_last_not_of('0') + 1));
    out.point = std::atoi(text.c_str() + exponent + 1) + 1;
    return out;
}

std::string without_exponent(const Decimal& number)
{
    const std::string sign = number.is_negative ? "-" : "";
    const int count = static_cast<int>(number.digits.size());
    if (number.point <= 0) return sign + "0." + std::string(static_cast<std::size_t>(-number.point), '0') + number.digits;
    const auto point = static_cast<std::size_t>(number.point);
    if (number.point >= count) return sign + number.digits + std::string(point - number.digits.size(), '0');
    return sign + number.digits.substr(0, point) + "." + number.digits.substr(point);
}

std::string with_exponent(const Decimal& number)
{
    const std::string sign = number.is_negative ? "-" : "";
    const std::string rest = number.digits.size() > 1 ? "." + number.digits.substr(1) : "";
    const int exponent = number.point - 1;
    const std::string size = std::to_string(std::abs(exponent));
    return sign + number.digits[0] + rest + (exponent < 0 ? "e-" : "e+") + (size.size() < 2 ? "0" : "") + size;
}

} // namespace

namespace by_c_library {

std::string number_text(double x)
{
    if (!std::isfinite(x)) return printed("%.*g", 1, x);
    const Decimal number = shortest(x);
    const std::string plain = without_exponent(number);
    const std::string other = with_exponent(number);
    return plain.size() <= other.size() ? plain : other;
}

std::string plain_number_text(double x)
{
    return without_exponent(shortest(x));
}

std::string rounded_text(double x, int digits)
{
    return printed("%.*g", digits, x);
}

} // namespace by_c_library

#ifdef __wasm__ // in place of math/number_text.cpp

std::string number_text(double x)
{
    return by_c_library::number_text(x);
}

std::string plain_number_text(double x)
{
    return by_c_library::plain_number_text(x);
}

std::string rounded_text(double x, int digits)
{
    return by_c_library::rounded_text(x, digits);
}

#endif

} // namespace flying
