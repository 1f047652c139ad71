#pragma once

#include <filesystem>
#include <set>
#include <string_view>

#include "weave/material.hpp"
#include "weave/problems.hpp"

namespace flying::weave {

/// The signs that a page, a script or a sheet shows, as code points: ASCII's, those that it holds, and those that it
/// names by `\u2212` or `\2212`.
void add_signs(std::string_view text, std::set<unsigned>& signs);

/// The book's letters and those of its formulas, each with the signs that the pages in `html` have: Debian's fonts hold
/// thousands. Made anew only where the signs are others than last time.
void make_letters(const Folders& folders, const std::filesystem::path& html, Problems& problems);

} // namespace flying::weave
