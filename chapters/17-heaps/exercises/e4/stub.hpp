#pragma once

#include <utility>
#include <vector>

/// Blocks beside the diagonal once all bodies are eliminated in an order; each pair of bodies counts once.
inline int blocks(int count, const std::vector<std::pair<int, int>>& pairs, const std::vector<int>& order)
{
    (void)count, (void)order;
    return static_cast<int>(pairs.size()); // your code here
}
