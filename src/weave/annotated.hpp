#pragma once

#include <filesystem>

#include "weave/finish.hpp"
#include "weave/material.hpp"
#include "weave/problems.hpp"

namespace flying::weave {

/// A page for each source, whole and in order: its comments as prose beside the code, which links to the manual; what
/// the story tells links to the story. They take the place of Doxygen's own pages of the sources, anchors included.
void write_annotated(const Material& material, const Manual& manual, const std::filesystem::path& html,
                     Problems& problems);

/// A map of each module, and one of all modules: the files with a line each, what each calls, and who calls it.
void write_module_maps(const Material& material, const Manual& manual, const std::filesystem::path& html,
                       Problems& problems);

/// A comment's text, from behind its slashes, as HTML: lists of parameters and references to formulas are understood.
[[nodiscard]] std::string comment_prose(const Material& material, const std::vector<std::string>& lines,
                                        const std::string& root);

} // namespace flying::weave
