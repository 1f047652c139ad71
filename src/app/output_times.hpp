#pragma once

#include <cmath>

namespace flying {

/// The moments 0, h, 2 h, ... up to the end, each a product, so that rounding never adds up.
class OutputTimes
{
public:
    /// step  h, positive  [s]
    /// end   not negative  [s]
    OutputTimes(double step, double end) : step_(step), end_(end) {}

    /// How many there are, as a double, which may be far over what a long holds. A moment that misses the end by
    /// rounding alone counts.
    [[nodiscard]] double count() const { return std::floor(end_ / step_ * (1.0 + 1e-12)) + 1.0; }

    [[nodiscard]] bool is_over() const { return static_cast<double>(index_) >= count(); }

    /// The moment whose turn it is. Only where not over.  [s]
    [[nodiscard]] double next() const { return std::fmin(static_cast<double>(index_) * step_, end_); }

    void advance() { ++index_; }

    /// Leave out what comes before a moment; one that misses it by rounding alone stays.  [s]
    void skip_to(double start)
    {
        const double first = std::ceil(start / step_ * (1.0 - 1e-12));
        index_ = first < count() ? static_cast<long>(first) : static_cast<long>(count());
    }

private:
    double step_;
    double end_;
    long index_ = 0;
};

} // namespace flying
