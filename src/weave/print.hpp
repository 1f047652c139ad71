#pragma once

#include <string>
#include <vector>

#include "weave/material.hpp"
#include "weave/pages.hpp"

namespace flying::weave {

/// A page and what it shows, with every token replaced.
struct FinishedPage
{
    const Page* page = nullptr;
    std::string body;
};

/// The name of the page for print: `print`, as the file `print.html`.
inline constexpr const char* k_print_page = "print";

/// The whole book as one page for print: a title, the contents, the chapters in order, then what one looks up in them.
/// An anchor `b` of the page `a` is `a.b` there, and links go to those; links to pages that aren't in it are words only.
/// docs/print.js makes a PDF of it, and fills in the numbers of the pages.
[[nodiscard]] std::string page_for_print(const Material& material, const std::vector<FinishedPage>& pages);

} // namespace flying::weave
