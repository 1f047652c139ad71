#pragma once

#include "rest/curved_ways.hpp"
#include "rest/heap_sweeps.hpp"
#include "rest/impacts.hpp"
#include "rest/projection.hpp"
#include "rest/rest_way.hpp"
#include "rest/slip_ends.hpp"

namespace flying {

/// What one island does in a step, or in a part of one: impacts, then forces, then ways, and the verdict on them.
class IslandStep
{
public:
    /// Finds velocities and impulses, or that the part is to end before: then `island.cut_at` is that moment.
    ///
    /// may_be_parted  there may be more parts of the island's step
    void find(RestData& data, Island& island, bool may_be_parted);

    /// The verdict on what was found for an island: the moment at which its step is to end early, or 0 where it stands,
    /// with its overlap taken off.  [s]
    ///
    /// may_be_halved  there may be more parts, where nothing says where to part it
    /// within         where a look into the whole step goes; null where there is none
    [[nodiscard]] double end_early(RestData& data, Island& island, bool may_be_halved, WithinStep* within);

private:
    void find_lossless(RestData& data, Island& island, bool sweeps);
    void look_within(RestData& data, const Island& island, WithinStep& within);

    // The stages, each with what it needs for its own work
    Impacts impacts_;
    SlipEnds slip_ends_;
    CurvedWays curves_;
    HeapSweeps sweeps_;
    Projection projection_;
};

} // namespace flying
