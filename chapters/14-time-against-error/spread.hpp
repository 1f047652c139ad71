#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

/// How long something takes, on a machine that does other things as well.
namespace flying::work {

// [work.spread]
/// A quarter of the values lie below `low`, half below `median`, three quarters below `high`.
struct Spread
{
    double low = 0.0;
    double median = 0.0;
    double high = 0.0;
};

/// The value below which this share of sorted values lies; between two values, on the straight
/// line from one to the other. Of no values, 0.
[[nodiscard]] inline double quantile(std::span<const double> sorted, double share)
{
    if (sorted.empty()) return 0.0;
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    const double rest = place - static_cast<double>(below);
    if (sorted[below] == sorted[above]) return sorted[below]; // also where both are infinite
    return sorted[below] + rest * (sorted[above] - sorted[below]);
}

[[nodiscard]] inline Spread spread_of(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return {quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75)};
}
// [work.spread]

// [work.prepare]
/// Gets everything ready, and returns what the clock is to see.
using Prepare = std::function<std::function<void()>()>;
// [work.prepare]

// [work.in_turn]
/// Time all of them in rounds: once each, there and back again in the next round.
/// seconds  a clock that only goes forward [s]
/// Returns the seconds of each, one for every round.
template <typename Clock>
[[nodiscard]] std::vector<std::vector<double>> time_in_turn(std::span<const Prepare> prepares, int rounds,
                                                            const Clock& seconds)
{
    std::vector<std::vector<double>> times(prepares.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t k = 0; k < prepares.size(); ++k) {
            const std::size_t turn = round % 2 == 0 ? k : prepares.size() - 1 - k;
            const std::function<void()> run = prepares[turn]();
            const double start = seconds();
            run();
            times[turn].push_back(seconds() - start);
        }
    }
    return times;
}
// [work.in_turn]

} // namespace flying::work
