#pragma once

#include <cstdint>
#include <string>

/// The long runs of ./course stress.
namespace flying::stress {

/// What came out, counted and printed line by line as it comes.
class Tally
{
public:
    /// A finding: printed after "ok" or "FAILED".
    void result(bool passed, const std::string& line);
    /// Where a part is, for those who watch; shown on a terminal only.
    void progress(const std::string& line);
    /// More about the findings, as it is.
    void note(const std::string& line);

    [[nodiscard]] int passed() const { return passed_; }
    [[nodiscard]] int failed() const { return failed_; }

private:
    void wipe();

    int passed_ = 0;
    int failed_ = 0;
    bool has_progress_ = false;
};

/// How long and from where.
struct Job
{
    std::uint64_t seed = 1; ///< of the first case; the next ones count upwards
    long count = 0;         ///< of what the part counts
    long row = 0;           ///< of the table, this one alone; 0 for all
};

void run_roots(const Job& job, Tally& tally);
void run_shift(const Job& job, Tally& tally);
void run_skips(const Job& job, Tally& tally);
void run_savings(const Job& job, Tally& tally);
void run_billiard(const Job& job, Tally& tally);
void run_reversal(const Job& job, Tally& tally);
void run_orbits(const Job& job, Tally& tally);
void run_gas(const Job& job, Tally& tally);
void run_speeds(const Job& job, Tally& tally);
void run_spins(const Job& job, Tally& tally);
void run_cooling(const Job& job, Tally& tally);
void run_collapse(const Job& job, Tally& tally);
void run_tests(const Job& job, Tally& tally);
/// The tests of the part, a line each.
void print_tried();
void run_rest(const Job& job, Tally& tally);
/// The rows of chapter 17's table. What was reached goes to out/stress/table.jsonl, row by row.
void run_table(const Job& job, Tally& tally);

} // namespace flying::stress
