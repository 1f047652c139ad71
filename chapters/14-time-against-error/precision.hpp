#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

/// Points of time and error, and what can be read off them.
namespace flying::work {

// [work.point]
/// One run of one engine with one setting.
struct Point
{
    double seconds = 0.0; ///< of computing, > 0 [s]
    double error = 0.0;   ///< >= 0, in whatever unit the diagram has
};
// [work.point]

// [work.slope]
/// The exponent p of y ~ x^p that fits best: the slope of the straight line through the points
/// (log x, log y) by least squares. Values are positive; fewer than two points have none.
[[nodiscard]] inline std::optional<double> slope(std::span<const double> x, std::span<const double> y)
{
    const auto n = static_cast<double>(x.size());
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        mean_x += std::log(x[k]) / n;
        mean_y += std::log(y[k]) / n;
    }
    double with = 0.0;
    double square = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double d = std::log(x[k]) - mean_x;
        with += d * (std::log(y[k]) - mean_y);
        square += d * d;
    }
    if (square == 0.0) return std::nullopt;
    return with / square;
}
// [work.slope]

// [work.time_at]
/// The least time in which an engine has an error of `error` or less: of the points that are as
/// good as that, the quickest. Nothing where none is.   [s]
[[nodiscard]] inline std::optional<double> time_at(std::span<const Point> points, double error)
{
    std::optional<double> best;
    for (const Point& point : points) {
        if (!(point.error <= error)) continue;
        if (!best || point.seconds < *best) best = point.seconds;
    }
    return best;
}
// [work.time_at]

// [work.ratios]
/// At one error that a peer has reached: our time over the best peer's.
struct Ratio
{
    double error = 0.0;
    std::optional<double> ours_over_theirs; ///< nothing where we don't reach that error
};

/// The ratio at every error that one of the peers' points has, from large errors to small.
[[nodiscard]] inline std::vector<Ratio> ratios(std::span<const Point> ours, std::span<const Point> theirs)
{
    std::vector<Ratio> all;
    for (const Point& reached : theirs) {
        const double best = time_at(theirs, reached.error).value();
        const std::optional<double> own = time_at(ours, reached.error);
        all.push_back({reached.error, std::nullopt});
        if (own) all.back().ours_over_theirs = *own / best;
    }
    std::sort(all.begin(), all.end(), [](const Ratio& a, const Ratio& b) { return a.error > b.error; });
    return all;
}
// [work.ratios]

} // namespace flying::work
