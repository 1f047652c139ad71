#pragma once

#include <string>

/// What math/number_text.hpp promises, by the C library, in its own locale: for the page's module: its standard
/// library has such functions only with tables of a hundred kilobytes, which every page would carry.
namespace flying::by_c_library {

[[nodiscard]] std::string number_text(double x);
[[nodiscard]] std::string plain_number_text(double x);
[[nodiscard]] std::string rounded_text(double x, int digits);

} // namespace flying::by_c_library
