#pragma once

#include <numeric>
#include <utility>
#include <vector>

/// For each body the smallest number of a body of its island. contacts  pairs of bodies that touch
inline std::vector<int> islands(const std::vector<bool>& is_static, const std::vector<std::pair<int, int>>& contacts)
{
    std::vector<int> below(
        is_static.size()); // a body of the same island with no larger number; itself for the smallest
    std::iota(below.begin(), below.end(), 0);
    const auto end_of = [&](int k) {
        while (below[k] != k) {
            below[k] = below[below[k]]; // shorten the path by every other step
            k = below[k];
        }
        return k;
    };
    for (const auto& [a, b] : contacts) {
        if (is_static[a] || is_static[b]) continue;
        const int end_a = end_of(a);
        const int end_b = end_of(b);
        if (end_a < end_b) below[end_b] = end_a;
        else below[end_a] = end_b;
    }
    for (int k = 0; k < static_cast<int>(below.size()); ++k) below[k] = end_of(k);
    return below;
}
