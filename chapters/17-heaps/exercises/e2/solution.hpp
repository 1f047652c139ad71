#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

/// Of each body, the lowest of its island; -1 where it doesn't move.
inline std::vector<int> islands(int count, const std::vector<std::pair<int, int>>& pairs,
                                const std::vector<char>& moves)
{
    std::vector<int> parent(count);
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int k) {
        while (parent[k] != k) k = parent[k] = parent[parent[k]];
        return k;
    };
    for (const auto& [a, b] : pairs) {
        if (!moves[a] || !moves[b]) continue;
        const int one = root(a);
        const int two = root(b);
        parent[std::max(one, two)] = std::min(one, two);
    }
    std::vector<int> result;
    for (int k = 0; k < count; ++k) result.push_back(moves[k] ? root(k) : -1);
    return result;
}
