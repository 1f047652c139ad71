#pragma once

#include <span>
#include <vector>

#include "rest/island.hpp"
#include "rest/island_sweeps.hpp"
#include "rest/local_sweeps.hpp"

namespace flying {

/// Islands whose impulses the direct solve doesn't find at once: each step goes on with the sweeps of the last.
class HeapSweeps
{
public:
    /// True where an island that stood comes to rest again with the impulses that it had: it keeps them, and all of its
    /// step is found. Else its velocities are still to be found.
    [[nodiscard]] bool stays(RestData& data, Island& island) const;
    /// The step of an island of any size, of first order: impulses, velocities, and the ways that it leads.
    void sweep_large(RestData& data, Island& island);
    /// Sweeps over what the direct solve rarely finds where a heap moves, for all its factorisations.
    /// velocities  of all bodies, to be changed
    void sweep_velocities(RestData& data, const Island& island, std::span<Mover> velocities,
                          std::span<ContactPoint> points);
    /// The same for places: pushes that take off overlap.
    /// tolerance  where no point asks for a greater change, pushes stay as they are [m]
    void sweep_places(RestData& data, const Island& island, std::span<Mover> pushes, std::span<ContactPoint> points,
                      double tolerance);

private:
    /// How near sweeps must come.
    struct Aim
    {
        double span = 1.0;       ///< for so long what points miss sums up [s]; 1 where places are swept
        bool is_landing = false; ///< energy is lost that pays for taking off overlap
    };

    void set_velocity_bias_swept(const RestData& data, const Island& island, bool is_calm) const;
    void settle(RestData& data, const Island& island, std::span<ContactPoint> points, double speed);
    void sweep(RestData& data, const Island& island, std::span<Mover> movers, std::span<ContactPoint> points,
               double tolerance);
    void sweep_on(RestData& data, const Island& island, std::span<Mover> movers, std::span<ContactPoint> points,
                  const Aim& aim);
    void allow(const RestData& data, std::span<const ContactPoint> points, double most);

    IslandSweeps sweeps_;
    LocalSweeps local_;
    std::vector<double> allowed_; // for each point: by how much it may miss its bound [m/s], or [m]
};

} // namespace flying
