#pragma once

namespace flying {

/// How the pairs that might meet are found: by looking at all of them, or at those in
/// neighbouring cells.
enum class PairFinder
{
    all_pairs,
    grid
};

} // namespace flying
