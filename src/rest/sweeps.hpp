#pragma once

#include <span>

#include "rest/contact_point.hpp"

namespace flying {

/// Apply the impulses that the points already hold, from the step before.
void warm_start(std::span<const ContactPoint> points, std::span<Mover> movers);

void forget_impulses(std::span<ContactPoint> points);

/// How far the worst point is from content: the change of its velocity that it would ask for.  [m/s]
[[nodiscard]] double worst_residual(std::span<const ContactPoint> points, std::span<const Mover> movers);
/// The same if none of them pushed anything, of velocities that none of them has changed.  [m/s]
[[nodiscard]] double worst_residual_of_none(std::span<const ContactPoint> points, std::span<const Mover> movers);
/// None asks for more than `tolerance`.  [m/s]
[[nodiscard]] bool are_satisfied(std::span<const ContactPoint> points, std::span<const Mover> movers, double tolerance);

/// One sweep over all points in their order: each in turn takes the impulse with which it alone would be content, the
/// normal first, then the friction in Coulomb's cone (projected Gauss-Seidel). What batches do to many points at once,
/// done plainly.
void sweep(std::span<ContactPoint> points, std::span<Mover> movers);

} // namespace flying
