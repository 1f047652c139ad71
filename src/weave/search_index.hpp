#pragma once

#include <string>

#include "weave/finish.hpp"
#include "weave/material.hpp"

namespace flying::weave {

/// What docs/theme/search.js looks through, as a script: chapters, sections with their words, terms where they are
/// introduced and in the glossary, words of other books, formulas, figures, symbols, and the names of the code.
[[nodiscard]] std::string search_index(const Material& material, const Manual& manual);

/// Words of other books have to lead to a heading that is there.
void check_other_words(const Material& material, Problems& problems);

} // namespace flying::weave
