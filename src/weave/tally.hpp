#pragma once

// What each chapter has, counted: for the page "The book in numbers" and for `weave check`.

#include <string>
#include <vector>

#include "weave/material.hpp"
#include "weave/problems.hpp"
#include "weave/rules.hpp"

namespace flying::weave {

/// Those that a chapter poses.
[[nodiscard]] ExerciseCount exercise_count(const Chapter& chapter);

struct Tally
{
    const Chapter* chapter = nullptr;
    int words = 0; ///< of the text, without code, formulas and exercises
    int listings = 0;
    double told = 1.0; ///< share of the lines of its files; 1 where it has none
    int figures = 0;
    int live = 0;
    int oracle = 0; ///< equations held against an independent oracle, those that are exact among them
    int measured = 0;
    int same = 0;
    int derivations = 0;
    int definitions = 0;
    ExerciseCount exercises;
    double worst = 0.0;     ///< largest error against an oracle
    std::string worst_name; ///< the equation's id; empty where there is none, or no error
};

/// One for each written chapter, in order.
[[nodiscard]] std::vector<Tally> tallies(const Material& material, const Coverage& coverage);

/// What all of them have together; the worst is the worst of all.
[[nodiscard]] Tally sum_of(const std::vector<Tally>& tallies);

/// Every chapter has as many exercises of each kind as `[exercises]` of book.toml asks for.
void check_exercises(const Material& material, Problems& problems);

/// The tables of the page, in Markdown.
[[nodiscard]] std::string tally_tables(const std::vector<Tally>& tallies);

/// A line for each chapter, as `weave check` prints it.
[[nodiscard]] std::string tally_lines(const std::vector<Tally>& tallies);

} // namespace flying::weave
