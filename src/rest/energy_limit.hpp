#pragma once

#include <span>

#include "rest/island.hpp"

namespace flying {

/// What an island has gained in a step, or a part of one, beyond the field's work.
struct EnergyGain
{
    double gained = 0.0; ///< [J]
    double scale = 0.0;  ///< sum of the sizes of all that `gained` is made of [J]
};
[[nodiscard]] EnergyGain gain_of(const RestData& data, const Island& island);

/// Kinetic energy of a body, and of an island's bodies with some velocities.  [J]
[[nodiscard]] double kinetic_energy(const Mover& mover);
[[nodiscard]] double kinetic_energy(const Island& island, std::span<const Mover> movers);

/// A body's motion isn't worth what rounding leaves of the energy that would lift it by its own size.
[[nodiscard]] bool is_all_but_still(const RestData& data, int body, const Mover& mover);

/// How far bodies get with the velocities that impulses bring them.
enum class Way
{
    none,          ///< in an impact: nothing moves, and the field does nothing
    mean_velocity, ///< for the step, by the mean of the velocities before and after
    end_velocity,  ///< for the step, by the velocities after
};

/// Impulses that were not found to rounding may give an island energy, or take some, beyond the field's work. With this
/// share of them all neither happens; 1 where rounding explains what does.
/// before, after  velocities of all bodies, without the impulses and with them; without them the field acts on the way
[[nodiscard]] double neutral_share(const RestData& data, const Island& island, std::span<const Mover> before,
                                   std::span<const Mover> after, Way way);

/// Velocities with a share of the impulses.
/// after  to be changed
void take_share(const RestData& data, const Island& island, std::span<const Mover> before, std::span<Mover> after,
                Way way, double share);

/// Counts what a step has nevertheless taken from such an island, after its impacts and besides what the field did.
void count_elastic_loss(RestData& data, const Island& island);

/// Energy that the limit may take from the motion of an island's bodies without changing momentum of its own.  [J]
[[nodiscard]] double energy_to_spare(const RestData& data, const Island& island, std::span<const Mover> velocities);

/// The one limit of energy: what a step has gained beyond the field's work is taken from the motion of bodies relative
/// to the one that nothing outside resists, and where there is too little, from the way that they rise relative to it.
/// Momentum that is the island's own stays. Counted, since it changes the motion.
void limit_energy(RestData& data, const Island& island);

} // namespace flying
