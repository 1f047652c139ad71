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

} // namespace flying
