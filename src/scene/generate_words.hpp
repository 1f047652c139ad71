#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "math/expected.hpp"
#include "scene/generate.hpp"
#include "scene/read.hpp"

namespace flying {

/// A scene as TOML text that `read_scene_text` takes.
/// comment  as `write_scene` has it
/// largest  text [bytes]
/// Faults are those of `generate`; and at `count`, a text that is larger.
[[nodiscard]] Expected<std::string> generate_text(const std::string& kind, const GenerateOptions& options,
                                                  const std::string& comment, std::size_t largest = k_largest_scene);

/// A scene as TOML text from the words that `flying generate` takes, such as `gas --count 40 --seed 7`: the same words,
/// the same text.
///
/// words  apart by blanks: the kind, then options, each with its values
///
/// Faults, all together: words that are no option, values that are missing, too many, or no numbers; then those that
/// `generate_text` finds. Placed at the option as it is typed (`--max-spin`).
[[nodiscard]] Expected<std::string> generate_from_words(std::string_view words);

} // namespace flying
