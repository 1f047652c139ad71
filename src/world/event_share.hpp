#pragma once

#include <algorithm>
#include <cstdint>

namespace flying {

/// How many events a caller asks of `World::advance` at once, so that in between it can look at the clock, at signals,
/// or at a screen. An event takes a microsecond, a step of a large heap a tenth of a second: from what the last share
/// took follows the next. It changes when a caller looks, and nothing of what the world does.
class EventShare
{
public:
    [[nodiscard]] std::int64_t size() const { return size_; }

    /// seconds  what the last share took [s]
    void took(double seconds)
    {
        if (seconds < k_short) size_ = std::min(2 * size_, k_most);
        else if (seconds > k_long) size_ = std::max<std::int64_t>(size_ / 8, 1);
    }

private:
    static constexpr double k_short = 0.005; // [s]
    static constexpr double k_long = 0.02;   // [s]
    static constexpr std::int64_t k_most = 4096;

    std::int64_t size_ = 1;
};

} // namespace flying
