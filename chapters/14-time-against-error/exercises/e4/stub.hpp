#pragma once

#include <vector>

/// Whose turn it is, 0 or 1, in each of 2^k turns, so that drifts of a degree below k cancel.
/// k  1 ... 16
inline std::vector<int> fair_order(int k)
{
    std::vector<int> order;
    for (int turn = 0; turn < (1 << k); ++turn) order.push_back(turn % 2);
    return order;
}
