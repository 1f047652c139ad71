#include "math/number_text.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace flying {

namespace {

/// A whole number of any size that is not negative: 32 bits a digit, the lowest first, no zeros at the end.
class Whole
{
public:
    explicit Whole(std::uint64_t value)
        : digits_{static_cast<std::uint32_t>(value), static_cast<std::uint32_t>(value >> 32)}
    {
        trim();
    }

    void times(std::uint32_t factor)
    {
        std::uint64_t carry = 0;
        for (std::uint32_t& digit : digits_) {
            carry += static_cast<std::uint64_t>(digit) * factor;
            digit = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        if (carry != 0) digits_.push_back(static_cast<std::uint32_t>(carry));
        trim();
    }

    void times_power(std::uint32_t base, int exponent)
    {
        for (int k = 0; k < exponent; ++k) times(base);
    }

    void add(const Whole& other)
    {
        digits_.resize(std::max(digits_.size(), other.digits_.size()) + 1, 0);
        std::uint64_t carry = 0;
        for (std::size_t k = 0; k < digits_.size(); ++k) {
            carry += static_cast<std::uint64_t>(digits_[k]) + other.digit(k);
            digits_[k] = static_cast<std::uint32_t>(carry);
            carry >>= 32;
        }
        trim();
    }

    /// other  no larger
    void take(const Whole& other)
    {
        std::uint64_t borrowed = 0;
        for (std::size_t k = 0; k < digits_.size(); ++k) {
            const std::uint64_t taken = other.digit(k) + borrowed;
            borrowed = digits_[k] < taken ? 1 : 0;
            digits_[k] = static_cast<std::uint32_t>(digits_[k] - taken);
        }
        trim();
    }

    /// -1, 0 or 1, as this is less than, equal to or more than the other.
    [[nodiscard]] int compare(const Whole& other) const
    {
        for (std::size_t k = std::max(digits_.size(), other.digits_.size()); k-- > 0;)
            if (digit(k) != other.digit(k)) return digit(k) < other.digit(k) ? -1 : 1;
        return 0;
    }

private:
    [[nodiscard]] std::uint32_t digit(std::size_t k) const { return k < digits_.size() ? digits_[k] : 0; }
    void trim()
    {
        while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
    }

    std::vector<std::uint32_t> digits_;
};

[[nodiscard]] Whole sum(Whole a, const Whole& b)
{
    a.add(b);
    return a;
}

/// sign 0.digits * 10^point
struct Decimal
{
    bool is_negative = false;
    std::string digits; ///< without zeros at the end, but "0" itself
    int point = 0;
};

/// One more in the last place.
void round_up(Decimal& number)
{
    while (!number.digits.empty() && number.digits.back() == '9') number.digits.pop_back();
    if (number.digits.empty()) {
        number.digits = "1";
        ++number.point;
    } else {
        ++number.digits.back();
    }
}

/// The digits of a finite number, from a quotient of whole numbers, one after the other: so many, the last rounded, or
/// for 0 as many as it takes to tell the number from its neighbours (R. Burger and R. Dybvig, 1996).
Decimal decimal(double x, int count)
{
    const auto bits = std::bit_cast<std::uint64_t>(x);
    Decimal out;
    out.is_negative = bits >> 63 != 0;
    if (x == 0.0) {
        out.digits = "0";
        out.point = 1;
        return out;
    }
    // x = mantissa 2^exponent
    constexpr std::uint64_t k_one = std::uint64_t{1} << 52;
    const int biased = static_cast<int>(bits >> 52 & 0x7ff);
    const std::uint64_t mantissa = (bits & (k_one - 1)) | (biased > 0 ? k_one : 0);
    const int exponent = std::max(biased, 1) - 1075;
    // Below a power of two the next number is half as far
    const std::uint32_t scale = mantissa == k_one && biased > 1 ? 4 : 2;

    // x = rest / whole, and what lies nearer than `above` or `below` reads back as x, with the ends where the mantissa
    // is even
    Whole rest(mantissa);
    Whole whole(scale);
    Whole below(count == 0 ? 1 : 0);
    rest.times(scale);
    rest.times_power(2, std::max(exponent, 0));
    below.times_power(2, std::max(exponent, 0));
    whole.times_power(2, std::max(-exponent, 0));
    Whole above = below;
    if (scale == 4) above.times(2);
    const int end = mantissa % 2 == 0 ? 0 : 1; // what a comparison must reach

    constexpr double k_log_2 = 0.30102999566398120;
    const int power = exponent + static_cast<int>(std::bit_width(mantissa)) - 1;
    out.point = static_cast<int>(std::ceil(power * k_log_2 - 1e-10));
    whole.times_power(10, std::max(out.point, 0));
    for (Whole* part : {&rest, &above, &below}) part->times_power(10, std::max(-out.point, 0));
    // That was it, or one too few
    if (sum(rest, above).compare(whole) >= (count == 0 ? end : 0)) ++out.point;
    else
        for (Whole* part : {&rest, &above, &below}) part->times(10);

    while (true) {
        char digit = '0';
        for (; rest.compare(whole) >= 0; ++digit) rest.take(whole);
        out.digits += digit;
        const bool is_last = count != 0 && static_cast<int>(out.digits.size()) == count;
        const bool may_stay = count == 0 && rest.compare(below) <= -end;
        const bool may_rise = count == 0 && sum(rest, above).compare(whole) >= end;
        if (is_last || may_stay || may_rise) {
            const int half = sum(rest, rest).compare(whole);
            const bool is_nearer_above = half > 0 || (half == 0 && (digit - '0') % 2 != 0);
            if (is_last || (may_stay && may_rise) ? is_nearer_above : may_rise) round_up(out);
            break;
        }
        for (Whole* part : {&rest, &above, &below}) part->times(10);
    }
    out.digits.resize(std::max<std::size_t>(1, out.digits.find_last_not_of('0') + 1));
    return out;
}

/// "nan", "-nan", "inf", "-inf".
std::string text_of_no_number(double x)
{
    return std::string(std::signbit(x) ? "-" : "") + (std::isnan(x) ? "nan" : "inf");
}

std::string without_exponent(const Decimal& number)
{
    const std::string sign = number.is_negative ? "-" : "";
    const int count = static_cast<int>(number.digits.size());
    if (number.point <= 0)
        return sign + "0." + std::string(static_cast<std::size_t>(-number.point), '0') + number.digits;
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

#ifdef __cpp_lib_to_chars
template <typename... Ways>
std::string by_standard_library(double x, Ways... ways)
{
    char text[400]; // the longest has 309 digits
    return std::string(text, std::to_chars(text, text + sizeof text, x, ways...).ptr);
}
#endif

} // namespace

namespace by_hand {

std::string number_text(double x)
{
    if (!std::isfinite(x)) return text_of_no_number(x);
    const Decimal number = decimal(x, 0);
    const std::string plain = without_exponent(number);
    const std::string other = with_exponent(number);
    return plain.size() <= other.size() ? plain : other;
}

std::string plain_number_text(double x)
{
    return without_exponent(decimal(x, 0));
}

std::string rounded_text(double x, int digits)
{
    if (!std::isfinite(x)) return text_of_no_number(x);
    const Decimal number = decimal(x, digits);
    return number.point > -4 && number.point <= digits ? without_exponent(number) : with_exponent(number);
}

} // namespace by_hand

#ifdef __cpp_lib_to_chars

std::string number_text(double x)
{
    return by_standard_library(x);
}

std::string plain_number_text(double x)
{
    return by_standard_library(x, std::chars_format::fixed);
}

std::string rounded_text(double x, int digits)
{
    return by_standard_library(x, std::chars_format::general, digits);
}

#else

std::string number_text(double x)
{
    return by_hand::number_text(x);
}

std::string plain_number_text(double x)
{
    return by_hand::plain_number_text(x);
}

std::string rounded_text(double x, int digits)
{
    return by_hand::rounded_text(x, digits);
}

#endif

} // namespace flying
