#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "rest/body_set.hpp"
#include "world/policy.hpp"

namespace flying {

/// Which integrator moves each body, and which bodies each has.
class Movers
{
public:
    explicit Movers(std::vector<BodyMover> movers = {}) : movers_(std::move(movers))
    {
        bodies_.fill(BodySet(static_cast<int>(movers_.size())));
        std::array<std::vector<int>, k_count> lists;
        for (std::size_t k = 0; k < movers_.size(); ++k) {
            lists[static_cast<std::size_t>(movers_[k])].push_back(static_cast<int>(k));
        }
        for (std::size_t k = 0; k < k_count; ++k) bodies_[k].insert(lists[k]);
    }

    [[nodiscard]] BodyMover of(int body) const { return movers_[body]; }
    [[nodiscard]] const std::vector<BodyMover>& all() const { return movers_; }
    /// Ascending.
    [[nodiscard]] std::span<const int> list(BodyMover mover) const
    {
        return bodies_[static_cast<std::size_t>(mover)].list();
    }

    void give(std::span<const int> bodies, BodyMover to)
    {
        if (bodies.empty()) return;
        for (BodySet& set : bodies_) set.erase(bodies);
        bodies_[static_cast<std::size_t>(to)].insert(bodies);
        for (const int body : bodies) movers_[body] = to;
    }

private:
    static constexpr std::size_t k_count = 4;
    std::vector<BodyMover> movers_;
    std::array<BodySet, k_count> bodies_; // of each mover
};

} // namespace flying
