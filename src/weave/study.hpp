#pragma once

#include <string>

#include "weave/book.hpp"

/// What helps a reader to study: goals and hours of a chapter, how to run its programs. HTML.
namespace flying::weave {

/// Under "What you need": how long the chapter takes, and what one can do afterwards.
[[nodiscard]] std::string goals_box(const ChapterEntry& entry);

/// Beside what a program printed: how to run it oneself. `program` is its name, such as `demo`.
[[nodiscard]] std::string run_box(const ChapterEntry& entry, const std::string& program);

} // namespace flying::weave
