#pragma once

#include <span>

#include "rest/island.hpp"

namespace flying {

/// Finds the impulses of an island's contacts over a length of time, and the velocities that they lead to.
/// start  velocities of the members as that time begins
/// time   its length [s]
/// `data.motion.now` and the points' impulses are what was found; `island.is_solved` says whether they are right.
void find_impulses(RestData& data, Island& island, std::span<const Mover> start, double time);

/// Sets the least normal velocities with which the step may end.
void set_velocity_bias(const RestData& data, const Island& island);
/// The same where nothing may be lost.
void set_lossless_bias(const RestData& data, const Island& island);
/// An open contact that closes on the ways that were found is to bear. True where there was any.
[[nodiscard]] bool close_missed(const RestData& data, const Island& island);
/// Takes for standing still what the solve's rounding alone moves.
void calm(RestData& data, const Island& island);

} // namespace flying
