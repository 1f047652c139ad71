#pragma once

#include <cmath>
#include <cstddef>
#include <span>

/// In how many of the rounds in which the two differ the first took longer, as a share; 0 where they never differ.
/// first, second  seconds of each, round by round, equally many
inline double share_of_rounds(std::span<const double> first, std::span<const double> second)
{
    int longer = 0;
    int differ = 0;
    for (std::size_t k = 0; k < first.size(); ++k) {
        longer += first[k] > second[k] ? 1 : 0;
        differ += first[k] != second[k] ? 1 : 0;
    }
    return differ == 0 ? 0.0 : static_cast<double>(longer) / differ;
}

/// Tosses of a coin would put the first behind as often in fewer than one case of a thousand.
inline bool is_slower(std::span<const double> first, std::span<const double> second)
{
    int longer = 0;
    int differ = 0;
    for (std::size_t k = 0; k < first.size(); ++k) {
        longer += first[k] > second[k] ? 1 : 0;
        differ += first[k] != second[k] ? 1 : 0;
    }
    double chance = 0.0;
    double cases = std::pow(0.5, differ); // all on the other side
    for (int k = 0; k <= differ; ++k) {
        if (k >= longer) chance += cases;
        cases *= static_cast<double>(differ - k) / (k + 1);
    }
    return chance < 1e-3;
}
