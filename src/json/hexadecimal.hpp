#pragma once

#include <cstdint>
#include <string>

namespace flying {

/// Sixteen digits, with zeros in front.
[[nodiscard]] inline std::string hexadecimal(std::uint64_t value)
{
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[value >> shift & 15u];
    return digits;
}

} // namespace flying
