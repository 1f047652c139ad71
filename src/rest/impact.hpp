#pragma once

#include <span>

#include "rest/contact_point.hpp"

namespace flying {

/// Throw back what arrives at contacts that are closed, by the law that the event engine has, too
/// (response/impacts_at_once.hpp): in rounds, as events come at one moment, so that a row of balls answers a blow as it
/// would in flight. Never adds energy.
///
/// velocities  of all bodies, changed for those that are struck
/// points      closed ones, those of two bodies in a row
/// slowest     of each point: an approach that is slower is left as it is [m/s]
/// rests       a point that parts no faster rests, and bears what others strike [m/s]
/// rounds      impacts at most, for each pair
///
/// Returns how many impacts there were. What approaches after the last one is left to a solve without rebound.
int throw_back(std::span<Mover> velocities, std::span<const ContactPoint> points, std::span<const double> slowest,
               double rests, int rounds);

/// End what approaches at all these points at once, without rebound, as impacts of the same law end that share bodies:
/// by compression. None parts slower than its bound.
///
/// enough  by how much bounds may be missed [m/s]
/// rounds  of Newton's method
///
/// Returns whether they were enough; nothing has changed where they weren't.
bool stop_at_once(std::span<Mover> velocities, std::span<const ContactPoint> points, double enough, int rounds);

} // namespace flying
