#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

/// A choice of bodies that breaks, and from which no single one can be left out.
/// all     a choice that breaks
/// breaks  whether a choice does
inline std::vector<int> fewest(std::vector<int> all, const std::function<bool(const std::vector<int>&)>& breaks)
{
    std::size_t part = std::max<std::size_t>(1, all.size() / 2);
    while (!all.empty()) {
        bool left_out = false;
        for (std::size_t start = 0; start < all.size();) {
            std::vector<int> rest(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(start));
            const std::size_t end = std::min(all.size(), start + part);
            rest.insert(rest.end(), all.begin() + static_cast<std::ptrdiff_t>(end), all.end());
            if (breaks(rest)) {
                all = rest; // what follows has moved up to `start`
                left_out = true;
            } else {
                start = end;
            }
        }
        if (part == 1 && !left_out) break;
        part = std::max<std::size_t>(1, part / 2);
    }
    return all;
}
