#pragma once

#include <utility>
#include <vector>

namespace flying {

/// Which bodies sleep, and with which others: an island falls asleep as a whole, and wakes as one.
class Sleepers
{
public:
    explicit Sleepers(int bodies) : island_(static_cast<std::size_t>(bodies), -1), next_(island_), first_(island_) {}

    [[nodiscard]] bool is_asleep(int body) const { return island_[body] >= 0; }
    /// The lowest body of its sleeping island; -1 where it is awake.
    [[nodiscard]] int island_of(int body) const { return island_[body]; }
    [[nodiscard]] int count() const { return count_; }

    /// body    awake
    /// island  its lowest body
    void put_to_sleep(int body, int island)
    {
        island_[body] = island;
        next_[body] = std::exchange(first_[island], body);
        ++count_;
        changed_.push_back(body);
    }
    /// Those of a sleeping island, in any order; none where island < 0.
    [[nodiscard]] std::vector<int> members(int island) const
    {
        std::vector<int> members;
        for (int body = island < 0 ? -1 : first_[island]; body >= 0; body = next_[body]) members.push_back(body);
        return members;
    }
    /// True where any of it slept.
    bool wake(int island)
    {
        if (island < 0 || first_[island] < 0) return false;
        for (int body = std::exchange(first_[island], -1); body >= 0; body = next_[body]) {
            island_[body] = -1;
            --count_;
            changed_.push_back(body);
        }
        return true;
    }

    /// Bodies that fell asleep or woke since this was asked last, in any order, some more than once.
    [[nodiscard]] std::vector<int> fetch_changed() { return std::exchange(changed_, {}); }

private:
    std::vector<int> island_;
    std::vector<int> next_;  // of each sleeping body, another of its island; -1 at the end
    std::vector<int> first_; // of each sleeping island, one of its bodies
    std::vector<int> changed_;
    int count_ = 0;
};

} // namespace flying
