#pragma once

#include <string>
#include <vector>

#include "weave/book.hpp"
#include "weave/chapter.hpp"

/// What helps a reader to study: goals and hours of a chapter, how to run its programs, both as HTML; and the glossary.
namespace flying::weave {

/// Under "What you need": how long the chapter takes, and what one can do afterwards.
[[nodiscard]] std::string goals_box(const ChapterEntry& entry);

/// Beside what a program printed: how to run it oneself. `program` is its name, such as `demo`.
[[nodiscard]] std::string run_box(const ChapterEntry& entry, const std::string& program);

/// A line of the glossary, `- **term**: meaning`.
struct Term
{
    std::string term;
    std::string meaning; ///< Markdown
    std::string anchor;  ///< of its line on the page
};

/// The terms that the glossary explains, in its order.
[[nodiscard]] std::vector<Term> terms_of(const ChapterText& glossary);

} // namespace flying::weave
