#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare.hpp"
#include "growth.hpp"
#include "machine.hpp"
#include "piles.hpp"

namespace flying::bench {

/// Everything that was measured in one run.
struct Results
{
    Machine machine;
    std::string started; ///< date and time
    std::vector<Comparison> scenes;
    std::vector<Growth> growths;
    std::vector<PileComparison> piles;
};

/// The table for people, as far as it has come.
[[nodiscard]] std::string table(const Results& results);

/// bench.json, and the data of the plots: NAME.dat, plots.ini for gnuplot.
void write_results(const Results& results, const std::filesystem::path& folder);

} // namespace flying::bench
