#pragma once

#include <set>
#include <string>
#include <vector>

#include "weave/material.hpp"
#include "weave/problems.hpp"

/// The rules that the text and the sources keep, apart from those of receipts. Each fails the build.
namespace flying::weave {

/// Engine lines and how many of them the written chapters show.
struct Coverage
{
    int lines = 0; ///< to be shown, in the files of written chapters
    int shown = 0;
    int waived = 0;
};

/// Every line of the engine is shown by its chapter, each region once as new.
[[nodiscard]] Coverage check_coverage(const Material& material, Problems& problems);

/// No decimal number is typed, no larger number in words; no formula or code stands where the build can't see it.
/// Returns how many numbers were declared as given.
int check_prose(const Material& material, Problems& problems);

/// A chapter has a demo, tests, a figure, an exercise, symbols and a summary; figures have words for those who don't
/// see them, and files.
void check_completeness(const Material& material, Problems& problems);

/// All texts of a chapter: its own, the rest of the code, those of its exercises.
[[nodiscard]] std::vector<const ChapterText*> texts_of(const Chapter& chapter);

} // namespace flying::weave
