#include "stress.hpp"

#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include <fmt/format.h>

namespace flying::stress {
namespace {

/// A program of tests, and which of its test cases try random cases (support/effort.hpp).
struct Tried
{
    std::string_view program;
    std::string_view tests; ///< as doctest's --test-case has it
};

constexpr std::array k_tried = {
    Tried{FLYING_PROPERTIES, "over random scenes that come to rest*"},
    Tried{FLYING_PROPERTIES, "with hand-overs*"},
    Tried{FLYING_PROPERTIES, "a run by steps of so many events*"},
    Tried{FLYING_PROPERTIES, "every skip leaves every bit*"},
    Tried{FLYING_PROPERTIES, "energy never rises*"},
    Tried{FLYING_PROPERTIES, "a run that is stopped, saved and resumed*"},
    Tried{FLYING_PROPERTIES, "lengths, times and masses*"},
    Tried{FLYING_STRESS_TESTS, "with any skip off*"},
    Tried{FLYING_STRESS_TESTS, "no first impact is missed*"},
    Tried{FLYING_STRESS_TESTS, "roots stay where they are*"},
    Tried{FLYING_STRESS_TESTS, "the dense search notices*"},
    Tried{FLYING_STRESS_TESTS, "random scenes at rest*"},
    Tried{FLYING_CHAPTER_13, "a row of dominoes*"},
    Tried{FLYING_CHAPTER_13, "a house of cards*"},
    Tried{FLYING_CHAPTER_13, "a hopper*"},
    Tried{FLYING_CHAPTER_13, "a see-saw*"},
    Tried{FLYING_CHAPTER_13, "a wall struck*"},
    Tried{FLYING_CHAPTER_13, "shapes like an L*"},
    Tried{FLYING_UNIT_TOI, "asking in pieces*"},
};

/// Commas part doctest's patterns.
std::string escaped(std::string_view pattern)
{
    std::string text;
    for (const char letter : pattern) {
        if (letter == ',') text += '\\';
        text += letter;
    }
    return text;
}

} // namespace

void print_tried()
{
    for (const Tried& tried : k_tried)
        fmt::print("  {:<12} {}\n", tried.program.substr(tried.program.rfind('/') + 1), tried.tests);
}

void run_tests(const Job& job, Tally& tally)
{
    for (const Tried& tried : k_tried) {
        tally.progress(fmt::format("tests: {}", tried.tests));

        // A pattern that no test has is a finding, too
        const std::string chosen = fmt::format("'{}' --no-intro --test-case='{}'", tried.program, escaped(tried.tests));
        const bool is_there = std::system((chosen + " --count --no-colors | grep -q 'filters: [1-9]'").c_str()) == 0;
        const std::string command = fmt::format("FLYING_TIMES={} {} --minimal", job.count, chosen);
        const bool passed = is_there && std::system(command.c_str()) == 0;
        tally.result(passed, fmt::format("tests: {} with {} times the cases of a test run", tried.tests, job.count));
    }
}

} // namespace flying::stress
