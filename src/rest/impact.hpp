#pragma once

#include <span>

#include "rest/contact_point.hpp"

namespace flying {

/// Throw back what arrives at contacts that are closed, by the law of two bodies that the event engine has, too
/// (response/impact.hpp): one after the other, always the first pair in the order of the points that arrives, until
/// no point approaches faster than it may: the order in which events come at one moment, so that a row of balls answers
/// a blow as it would in flight. Never adds energy, since no impact of two bodies does.
///
/// velocities  of all bodies, changed for those that are struck
/// points      closed ones, those of two bodies in a row
/// slowest     of each point: an approach that is slower is left as it is [m/s]
///
/// Returns how many impacts there were. What approaches after the last one is left to a solve without rebound.
int throw_back(std::span<Mover> velocities, std::span<const ContactPoint> points, std::span<const double> slowest);

} // namespace flying
