#pragma once

#include <optional>
#include <string>

#include "weave/chapter.hpp"
#include "weave/ledger.hpp"
#include "weave/material.hpp"
#include "weave/problems.hpp"

/// Rules against what a book may say and its build doesn't hold: numbers written as words, chapters said to be needed,
/// receipts that look like more than they are.
namespace flying::weave {

/// What a receipt proves. A word after the id on the equation's line.
enum class ReceiptKind
{
    oracle,   ///< no word: the engine's value against one found another way
    exact,    ///< `exact`: the same, and the two are equal to the last bit in every case
    measured, ///< `measured`: a result of runs, as near as they are long or fine
    same,     ///< `same`: the test repeats the code's own expression; no check of the formula
};

/// The kind that the equation's line names, or nothing where it names another word.
[[nodiscard]] std::optional<ReceiptKind> receipt_kind(const Block& equation);

/// The kind fits what the tests found: no error at all, or a bound far above rounding, has to be named.
void check_receipt_kind(const Block& equation, const EquationReceipt& receipt, Problems& problems);

/// A number from thirteen on that is written in words: `sixty`, `hundreds`, `half a minute`. Below, words are words.
/// A caption has none: what it says of a figure goes stale unseen.
[[nodiscard]] std::optional<std::string> number_word(const std::string& text);

/// Such a number with a word before it that makes it a result: `about a hundred`, `less than half a minute`. Running
/// text has none, while `a thousand discs` is no claim.
[[nodiscard]] std::optional<std::string> rough_number_word(const std::string& text);

/// The chapters that "What you need" names are those that book.toml says are needed.
void check_needs(const Material& material, Problems& problems);

} // namespace flying::weave
