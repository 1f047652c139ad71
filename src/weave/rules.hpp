#pragma once

#include <set>
#include <string>
#include <vector>

#include "weave/material.hpp"
#include "weave/problems.hpp"

/// The rules that the text and the sources keep, apart from those of receipts. Each fails the build.
namespace flying::weave {

/// Of how many lines of its files a chapter's story tells. What every file has,
/// includes and the like, doesn't count.
struct Share
{
    int chapter = 0;    ///< the number of its folder
    std::string called; ///< `chapter 2`, or `appendix A`
    int lines = 0;
    int told = 0;

    [[nodiscard]] double part() const { return lines == 0 ? 1.0 : static_cast<double>(told) / lines; }
};

/// The shares of the written chapters, in order.
struct Coverage
{
    std::vector<Share> shares;

    [[nodiscard]] Share sum() const;
};

/// Listings show what is there, each line once as new; a mark is there for a
/// listing; every chapter tells the share of its files that book.toml asks for.
[[nodiscard]] Coverage check_coverage(const Material& material, Problems& problems);

/// No decimal number is typed, no larger number in words; no formula or code stands where the build can't see it.
/// Each line of a derivation has a reason.
/// Returns how many numbers were declared as given.
int check_prose(const Material& material, Problems& problems);

/// A chapter has a demo, tests, a figure, an exercise, symbols and a summary; figures have words for those who don't
/// see them, and files.
void check_completeness(const Material& material, Problems& problems);

/// All texts of a chapter: its own, and those of its exercises.
[[nodiscard]] std::vector<const ChapterText*> texts_of(const Chapter& chapter);

} // namespace flying::weave
