#include "response/tied_pairs.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace flying {

std::vector<std::vector<int>> tied_pairs(std::span<const std::array<int, 2>> pairs)
{
    // Sort by bodies, so that the pairs of each stand in a row
    std::vector<std::pair<int, int>> of_body;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        for (const int body : pairs[k]) {
            if (body >= 0) of_body.emplace_back(body, static_cast<int>(k));
        }
    }
    std::sort(of_body.begin(), of_body.end());

    // Lead every pair to the first of its group
    std::vector<int> leads(pairs.size());
    std::iota(leads.begin(), leads.end(), 0);
    const auto first_of = [&](int k) {
        while (leads[k] != k) k = leads[k] = leads[leads[k]];
        return k;
    };
    for (std::size_t k = 1; k < of_body.size(); ++k) {
        if (of_body[k].first != of_body[k - 1].first) continue;
        const auto [low, high] = std::minmax({first_of(of_body[k - 1].second), first_of(of_body[k].second)});
        leads[high] = low;
    }
    std::vector<std::vector<int>> groups(pairs.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) groups[first_of(static_cast<int>(k))].push_back(static_cast<int>(k));
    std::erase_if(groups, [](const std::vector<int>& group) { return group.empty(); });
    return groups;
}

} // namespace flying
