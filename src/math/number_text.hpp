#pragma once

#include <string>

namespace flying {

/// The shortest decimal number that reads back as x; "nan", "inf", "-inf".
[[nodiscard]] std::string number_text(double x);

/// The same without an exponent, and so with all its zeros.
/// x  finite
[[nodiscard]] std::string plain_number_text(double x);

/// x with so many significant digits, for what was measured and not typed.
/// digits  1 ... 17
[[nodiscard]] std::string rounded_text(double x, int digits = 6);

/// What the three above are made by where the standard library has no such functions, or has them with tables of a
/// hundred kilobytes, which every page of the book would carry. They rest on the C library, in its own locale.
namespace by_c_library {

[[nodiscard]] std::string number_text(double x);
[[nodiscard]] std::string plain_number_text(double x);
[[nodiscard]] std::string rounded_text(double x, int digits);

} // namespace by_c_library

} // namespace flying
