#pragma once

#include <utility>
#include <vector>

/// For each body the smallest number of a body of its island. contacts  pairs of bodies that touch
inline std::vector<int> islands(const std::vector<bool>& is_static, const std::vector<std::pair<int, int>>& contacts)
{
    (void)contacts;
    return std::vector<int>(is_static.size(), 0); // your code here
}
