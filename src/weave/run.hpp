#pragma once

#include <string>
#include <vector>

#include "weave/material.hpp"
#include "weave/pages.hpp"
#include "weave/problems.hpp"

namespace flying::weave {

/// What the book is made with.
struct Tools
{
    std::string doxygen = "doxygen";
    std::string node = "node";
    std::string module{}; ///< the engine for pages, of WebAssembly; empty where there is none
};

/// Renders every formula, in one run of KaTeX for all that are new since the last time. One entry for each fragment;
/// bad TeX goes to `problems`.
[[nodiscard]] std::vector<std::string> render_formulas(const Fragments& fragments, const Folders& folders,
                                                       const Tools& tools, Problems& problems);

/// Everything that can be told without Doxygen: reads, checks every rule, and makes the pages.
struct Woven
{
    Material material;
    Counts counts;
    Pages pages;
    std::vector<std::string> formulas;
};
[[nodiscard]] Woven weave_pages(const Folders& folders, const Tools& tools, Problems& problems);

/// The whole book, from the chapters to `html` in the build folder. A book that fails leaves the last good one in
/// place.
void make_book(const Folders& folders, const Tools& tools, Problems& problems);

/// A comment's lines, from behind its slashes, as Markdown: aligned lists of parameters become lists.
[[nodiscard]] std::string comment_markdown(const std::vector<std::string>& lines);

/// A source as Doxygen reads it: the aligned lists of parameters in the comments become lists. Line numbers stay.
[[nodiscard]] std::string filter_source(const std::vector<std::string>& lines);
/// A source with the lines left blank that mark where regions begin and end: one that the filter leaves at that needs
/// none.
[[nodiscard]] std::string without_markers(const std::vector<std::string>& lines);

} // namespace flying::weave
