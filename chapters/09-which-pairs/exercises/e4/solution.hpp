#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "math/vec2.hpp"

using flying::Vec2;

/// Pairs (i, k), i < k, with a distance of at most `reach`, in order.
inline std::vector<std::pair<int, int>> near_pairs(const std::vector<Vec2>& points, double reach)
{
    const auto cell = [&](double x) { return static_cast<std::int64_t>(std::floor(x / reach)); };
    const auto key = [](std::int64_t column, std::int64_t row) { return column * 0x100000000 + row; };
    std::unordered_map<std::int64_t, std::vector<int>> cells;
    std::vector<std::pair<int, int>> pairs;

    // Each point looks for those that were put down before it, then puts itself down
    for (int k = 0; k < static_cast<int>(points.size()); ++k) {
        const std::int64_t column = cell(points[k].x());
        const std::int64_t row = cell(points[k].y());
        for (std::int64_t x = column - 1; x <= column + 1; ++x) {
            for (std::int64_t y = row - 1; y <= row + 1; ++y) {
                const auto found = cells.find(key(x, y));
                if (found == cells.end()) continue;
                for (const int i : found->second)
                    if ((points[i] - points[k]).squaredNorm() <= reach * reach) pairs.emplace_back(i, k);
            }
        }
        cells[key(column, row)].push_back(k);
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}
