// Long runs that try to prove the exact engine wrong: one line for each finding, the sum at the end.

#include "stress.hpp"

#include <charconv>
#include <cstdio>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

namespace flying::stress {

void Tally::wipe()
{
    if (has_progress_) std::fputs("\r\033[K", stderr);
    has_progress_ = false;
}

void Tally::result(bool passed, const std::string& line)
{
    wipe();
    ++(passed ? passed_ : failed_);
    fmt::print("{}  {}\n", passed ? "ok    " : "FAILED", line);
    std::fflush(stdout);
}

void Tally::note(const std::string& line)
{
    wipe();
    fmt::print("{}\n", line);
    std::fflush(stdout);
}

void Tally::progress(const std::string& line)
{
    if (isatty(STDERR_FILENO) == 0) return;
    fmt::print(stderr, "\r\033[K{:.100}", line);
    std::fflush(stderr);
    has_progress_ = true;
}

namespace {

struct Part
{
    std::string_view name;
    std::string_view what;
    std::string_view counted;
    long count;
    void (*run)(const Job&, Tally&);
};

constexpr Part k_parts[] = {
    {"roots", "first impacts against a dense search of its own", "pairs", 100'000'000, run_roots},
    {"shift", "the same impacts when all times are a million seconds later", "pairs", 1'000'000, run_shift},
    {"skips", "every bit after every impact with each skip off, over random scenes", "scenes", 10'000, run_skips},
    {"savings", "the work that each skip saves in the scenes of the chapters", "impacts a scene", 2'000, run_savings},
    {"billiard", "two balls and a wall count the digits of pi", "as exponent of 100 at most", 7, run_billiard},
    {"reversal", "1024 discs come back after 10 collisions each", "gases", 100, run_reversal},
    {"orbits", "ellipses of e = 0.6 come back", "turns", 1'000, run_orbits},
    {"gas", "pressure and collision rate of hard discs at packing 0.3", "collisions", 500'000'000, run_gas},
    {"speeds", "Maxwell's distribution in a gas that starts with one speed", "speeds", 10'000'000, run_speeds},
    {"spins", "equal shares of energy in a gas of squares that starts without spin", "spins", 1'000'000, run_spins},
    {"cooling", "a gas of discs at e = 0.99 cools as Haff says", "discs", 10'000, run_cooling},
    {"collapse", "a gas of discs at e = 0.1 collapses again and again, and goes on to its end", "discs", 10'000, run_collapse},
    {"tests", "the tests that try random cases, with more of them", "times as many", 10, run_tests},
    {"rest", "random scenes in which bodies come to rest: no body lost, no energy won, no overlap left", "scenes", 10'000, run_rest},
    {"table", "every row of chapter 17 that doesn't hold yet; the long ones go on where they stopped", "seconds for each long one", 600, run_table},
};

void print_help()
{
    fmt::print("./course stress [PART...] [--seed N] [--count N] [--row N]\n\n"
               "Without a part: all of them, hours. Each finding is a line; the last line is the sum.\n"
               "  --seed N    the first seed, 1 where it isn't given: a run with --seed 1 --count 1000 and one with\n"
               "              --seed 1001 --count 1000 make the run with --seed 1 --count 2000\n"
               "  --count N   how much of what the part counts\n"
               "  --row N     of the part `table`, this row alone\n\nParts:\n");
    for (const Part& part : k_parts)
        fmt::print("  {:<12} {} ({} {})\n", part.name, part.what, part.count, part.counted);
    fmt::print("\nThe part `tests` has the random cases that a test run has not, of these tests:\n");
    print_tried();
}

const Part* find_part(std::string_view name)
{
    for (const Part& part : k_parts) {
        if (part.name == name) return &part;
    }
    return nullptr;
}

/// A whole number, 1 or more; 0 where the text is none.
long number(std::string_view text)
{
    long value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && value > 0 ? value : 0;
}

int refuse(const std::string& why)
{
    fmt::print(stderr, "stress: {}; --help lists parts and options\n", why);
    return 2;
}

int run(const std::vector<std::string_view>& arguments)
{
    std::vector<const Part*> chosen;
    Job job;
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        const std::string_view word = arguments[k];
        if (word == "--help" || word == "-h") {
            print_help();
            return 0;
        }
        if (word == "--seed" || word == "--count" || word == "--row") {
            const long value = k + 1 < arguments.size() ? number(arguments[++k]) : 0;
            if (value == 0) return refuse(fmt::format("expected a positive number after {}", word));
            if (word == "--seed") job.seed = static_cast<std::uint64_t>(value);
            else if (word == "--row") job.row = value;
            else job.count = value;
        } else if (const Part* part = find_part(word)) {
            chosen.push_back(part);
        } else {
            return refuse(fmt::format("no part or option '{}'", word));
        }
    }
    if (chosen.empty()) {
        if (job.count != 0) return refuse("--count needs a part: each counts something else");
        for (const Part& part : k_parts) chosen.push_back(&part);
    }

    Tally tally;
    for (const Part* part : chosen) part->run({job.seed, job.count != 0 ? job.count : part->count, job.row}, tally);
    fmt::print("{} passed, {} failed\n", tally.passed(), tally.failed());
    return tally.failed() == 0 && tally.passed() > 0 ? 0 : 1;
}

} // namespace
} // namespace flying::stress

int main(int count, char** words)
{
    return flying::stress::run({words + 1, words + count});
}
