#pragma once

#include <string>
#include <utility>
#include <vector>

#include "weave/chapter.hpp"
#include "weave/material.hpp"
#include "weave/problems.hpp"

namespace flying::weave {

/// A line of a derivation: its formula and the reason beside it.
struct Step
{
    int line = 0; ///< in the file
    std::string tex;
    std::string reason;
};

/// The steps of a derivation's block; blank lines count for nothing.
[[nodiscard]] std::vector<Step> steps_of(const Block& block);

/// The formula of an equation's or a definition's block, on one line.
[[nodiscard]] std::string formula_of(const Block& block);

/// Holds every equation against its receipt, evaluates the printed formulas where the receipts give their quantities,
/// and evaluates the derivations that say `for`, whose receipts it adds to the ledger.
void check_receipts(Material& material, Problems& problems);

} // namespace flying::weave
