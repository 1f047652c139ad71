#pragma once

#include <string>
#include <vector>

namespace flying::weave {

/// A line of a file of the project. `file` is relative to the project's folder; `line` counts from 1, 0 is the file as
/// a whole.
struct Place
{
    std::string file;
    int line = 0;

    friend bool operator==(const Place&, const Place&) = default;
};

/// One reason why the book can't be built.
struct Problem
{
    Place place;
    std::string found;
    std::string expected;

    friend bool operator==(const Problem&, const Problem&) = default;
};

/// All that stands between the sources and the book, in the order in which it was met. Every rule adds to it and goes
/// on, so that one run tells everything.
class Problems
{
public:
    /// Adds it, unless the same is there already.
    void add(Place place, std::string found, std::string expected);

    [[nodiscard]] bool empty() const { return list_.empty(); }
    [[nodiscard]] const std::vector<Problem>& list() const { return list_; }

    /// One line each, place, what was found, what was expected; sorted by file and line.
    [[nodiscard]] std::string report() const;

private:
    std::vector<Problem> list_;
};

} // namespace flying::weave
