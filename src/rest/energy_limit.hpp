#pragma once

#include "rest/island.hpp"

namespace flying {

/// What an island has gained in a step, or a part of one, beyond the field's work.
struct EnergyGain
{
    double gained = 0.0; ///< [J]
    double scale = 0.0;  ///< sum of the sizes of all that `gained` is made of [J]
};
[[nodiscard]] EnergyGain gain_of(const RestData& data, const Island& island);

/// The one limit of energy: what a step has gained beyond the field's work is taken from the motion of bodies relative
/// to each other; where that isn't enough from all motion, and then from the way that they rise. Counted, since it
/// changes the motion.
void limit_energy(RestData& data, const Island& island);

} // namespace flying
