#pragma once

#include <set>
#include <utility>
#include <vector>

/// Blocks beside the diagonal once all bodies are eliminated in an order; each pair of bodies counts once.
inline int blocks(int count, const std::vector<std::pair<int, int>>& pairs, const std::vector<int>& order)
{
    std::vector<std::set<int>> neighbours(count);
    for (const auto& [a, b] : pairs) {
        neighbours[a].insert(b);
        neighbours[b].insert(a);
    }
    int sum = 0;
    for (const int gone : order) {
        const std::set<int> left = neighbours[gone];
        sum += static_cast<int>(left.size());
        for (const int one : left) {
            neighbours[one].erase(gone);
            for (const int other : left)
                if (other != one) neighbours[one].insert(other);
        }
    }
    return sum;
}
