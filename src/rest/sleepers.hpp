#pragma once

#include <algorithm>
#include <vector>

namespace flying {

/// Which bodies sleep, and with which others: an island falls asleep as a whole, and wakes as one.
class Sleepers
{
public:
    explicit Sleepers(int bodies) : island_(static_cast<std::size_t>(bodies), -1) {}

    [[nodiscard]] bool is_asleep(int body) const { return island_[body] >= 0; }
    /// The lowest body of its sleeping island; -1 where it is awake.
    [[nodiscard]] int island_of(int body) const { return island_[body]; }
    [[nodiscard]] int count() const { return count_; }

    /// island  its lowest body; -1 wakes
    void set(int body, int island)
    {
        count_ += (island >= 0 ? 1 : 0) - (island_[body] >= 0 ? 1 : 0);
        island_[body] = island;
    }
    /// True where any of it slept.
    bool wake(int island)
    {
        if (island < 0) return false;
        const auto woken = std::count(island_.begin(), island_.end(), island);
        std::replace(island_.begin(), island_.end(), island, -1);
        count_ -= static_cast<int>(woken);
        return woken > 0;
    }

private:
    std::vector<int> island_;
    int count_ = 0;
};

} // namespace flying
