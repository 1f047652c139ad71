#pragma once

#include <vector>

#include "rest/island.hpp"

namespace flying {

/// Parts a small island's step along straight lines where slip ends: friction that a slip has asked for ends with it,
/// and what sticks from there on needs another.
class SlipEnds
{
public:
    /// Where a slip has ended in the step that was found, finds it again in parts. `data.motion` then holds what the
    /// mean velocity of the step misses of the ways, too.
    void part(RestData& data, Island& island);

private:
    void add_part(RestData& data, const Island& island, double time);

    std::vector<Mover> start_; // of the part that is being made
};

} // namespace flying
