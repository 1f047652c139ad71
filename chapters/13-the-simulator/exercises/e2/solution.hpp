#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

/// The text with the fewest significant digits that reads back as the same double, to the
/// bit. x  finite
inline std::string shortest(double x)
{
    char text[40];
    for (int digits = 1; digits <= 17; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, x);
        const double back = std::strtod(text, nullptr);
        if (std::bit_cast<std::uint64_t>(back) == std::bit_cast<std::uint64_t>(x)) break;
    }
    return text;
}
