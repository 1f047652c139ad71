#pragma once

#include <bit>
#include <vector>

/// Whose turn it is, 0 or 1, in each of 2^k turns, so that drifts of a degree below k cancel.
/// k  1 ... 16
inline std::vector<int> fair_order(int k)
{
    // Doubled again and again with the two swapped, that is the parity of the ones in the number of the turn
    std::vector<int> order;
    for (unsigned turn = 0; turn < (1u << k); ++turn) order.push_back(std::popcount(turn) % 2);
    return order;
}
