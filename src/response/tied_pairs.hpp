#pragma once

#include <array>
#include <span>
#include <vector>

namespace flying {

/// Which pairs are tied together, through bodies that they share, directly or by others.
///
/// pairs  of bodies, each by its number; below 0 where one ties nothing, since it doesn't move
/// Returns groups of indices into `pairs`, all of them ascending, in the order of their first ones.
[[nodiscard]] std::vector<std::vector<int>> tied_pairs(std::span<const std::array<int, 2>> pairs);

} // namespace flying
