#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "weave/problems.hpp"

namespace flying::weave {

/// A case of an equation, for the printed formula: its quantities by their TeX, and the closed form's value.
struct Sample
{
    std::map<std::string, double> quantities;
    double value = 0.0;
};

/// What the tests found for one equation.
struct EquationReceipt
{
    std::int64_t cases = 0;
    bool passed = false;
    double worst = 0.0; ///< largest relative error
    double bound = 0.0; ///< that the tests allow
    std::string where;  ///< test of the worst case
    std::int64_t twins = 0;
    bool twins_rejected = false;
    double twin_bound = 0.0;
    std::vector<Sample> samples;
    int printed_cases = 0; ///< in which the formula was evaluated as it is printed; filled in by check_receipts()
};

/// What the tests, or the reading of the formulas themselves, found for the lines of one derivation.
struct DerivationReceipt
{
    int lines = 0;
    int points = 0;
    bool passed = false;
    double worst = 0.0;
    std::string where; ///< the test; empty where the printed lines were evaluated themselves
};

/// All receipts, and all numbers that the text may quote.
struct Ledger
{
    std::map<std::string, EquationReceipt> equations;
    std::map<std::string, DerivationReceipt> derivations;
    std::map<std::string, double> values;
};

/// Reads every `*.json` of the folder, as the test programs leave them.
[[nodiscard]] Ledger read_ledger(const std::filesystem::path& folder, Problems& problems);

/// Adds the numbers in what a program printed: a line `period error = 1.2e-15 s` of `demo` is the value
/// `demo.period-error`.
void add_printed_values(const std::string& program, const std::string& output, Ledger& ledger);

/// The number as `%.3g` and its like ask for, in HTML: an exponent becomes a power of ten. Nothing where `format` is
/// not the format of a single floating-point number.
[[nodiscard]] std::optional<std::string> format_value(double value, const std::string& format);

} // namespace flying::weave
