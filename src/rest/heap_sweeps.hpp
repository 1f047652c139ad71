#pragma once

#include <span>

#include "rest/island.hpp"
#include "rest/island_sweeps.hpp"

namespace flying {

/// Islands that are too large to be solved whole: each step goes on with the sweeps of the last.
class HeapSweeps
{
public:
    /// The step of such an island: impulses, velocities, and the ways that it leads.
    void sweep_large(RestData& data, Island& island);
    /// Sweeps over what the direct solve rarely finds where a heap moves, for all its factorisations.
    ///
    /// velocities  of all bodies, to be changed
    /// tolerance   where no point asks for a greater change, impulses stay as they are; below 0 they never do [m/s]
    void sweep_heap(RestData& data, const Island& island, std::span<Mover> velocities, std::span<ContactPoint> points,
                    double tolerance = -1.0);

private:
    void set_velocity_bias_swept(const RestData& data, const Island& island, bool is_calm) const;
    [[nodiscard]] double approaches_left(const RestData& data, std::span<const ContactPoint> points) const;
    void scale_impulses_to_energy(RestData& data, const Island& island);

    IslandSweeps sweeps_;
};

} // namespace flying
