#pragma once

#include <string>
#include <string_view>

namespace flying::weave {

/// An SVG whose paths go by steps, in tenths of its units: less than can be seen, and half of the bytes, since Cairo
/// writes every point in full, with six decimals. A path with more than moves, lines and curves to given points is left
/// as it is. Other numbers have two decimals at most, and letters that the drawing doesn't use are gone.
[[nodiscard]] std::string light_svg(std::string_view svg);

} // namespace flying::weave
