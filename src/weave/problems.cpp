#include "weave/problems.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

namespace flying::weave {

void Problems::add(Place place, std::string found, std::string expected)
{
    // A formula may be set in several places of the book: its fault is one
    Problem problem{std::move(place), std::move(found), std::move(expected)};
    if (std::find(list_.begin(), list_.end(), problem) == list_.end()) list_.push_back(std::move(problem));
}

std::string Problems::report() const
{
    std::vector<Problem> sorted = list_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
        return std::tie(a.place.file, a.place.line) < std::tie(b.place.file, b.place.line);
    });
    std::string text;
    for (const Problem& problem : sorted) {
        text += problem.place.line > 0 ? fmt::format("{}:{}: ", problem.place.file, problem.place.line)
                                       : fmt::format("{}: ", problem.place.file);
        text += fmt::format("{}; expected {}\n", problem.found, problem.expected);
    }
    return text;
}

} // namespace flying::weave
