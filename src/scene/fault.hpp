#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "math/expected.hpp"

namespace flying {

/// A fault as one line, without a line end: `scene.toml:12:9: body "left", shape.radius: found -1, expected a positive
/// length [m]`. A fault without `expected` says what it says in `found` alone; an empty place is left out.
[[nodiscard]] std::string format_fault(const Fault& fault);

/// One line per fault, each with its line end.
[[nodiscard]] std::string format_faults(const Faults& faults);

/// The known word that a mistyped one most likely meant: fewest letters changed, left out, added or swapped with their
/// neighbour, at most a third of the word's. Empty where nothing is near; the first of equals.
[[nodiscard]] std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

} // namespace flying
