#include "math/number_text.hpp"

#include <charconv>

namespace flying {
namespace {

template <typename... Ways>
std::string by_standard_library(double x, Ways... ways)
{
    char text[400]; // the longest has 309 digits
    return std::string(text, std::to_chars(text, text + sizeof text, x, ways...).ptr);
}

} // namespace

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

} // namespace flying
