#pragma once

#include <string>

namespace flying::weave {

/// Markdown as HTML: paragraphs, lists, tables, emphasis, links. HTML in it is not let through.
[[nodiscard]] std::string markdown_to_html(const std::string& markdown);

} // namespace flying::weave
