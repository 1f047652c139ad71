#pragma once

#include <string>
#include <string_view>

#include "math/expected.hpp"

namespace flying {

/// A scene as TOML text from the words that `flying generate` takes, such as `gas --count 40 --seed 7`: the same words,
/// the same text.
///
/// words  apart by blanks: the kind, then options, each with its values
///
/// Faults, all together: words that are no option, values that are missing, too many, or no numbers; then those that
/// `generate` finds. Placed at the option as it is typed (`--max-spin`).
[[nodiscard]] Expected<std::string> generate_from_words(std::string_view words);

} // namespace flying
