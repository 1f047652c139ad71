#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "rest/contact_point.hpp"

namespace flying {

/// Apply the impulses that the points already hold, from the step before.
void warm_start(std::span<const ContactPoint> points, std::span<Mover> movers);

void forget_impulses(std::span<ContactPoint> points);

/// How far a point is from content: the change of velocity that it would ask for.  [m/s]
[[nodiscard]] inline double residual(const ContactPoint& c, const Mover& a, const Mover& b)
{
    const double excess = normal_speed(c, a, b) - c.bound;
    const double normal = std::max(0.0, c.normal - c.normal_mass * excess);
    const double along_normal = std::abs(normal - c.normal) / c.normal_mass;

    const double most = c.friction * c.normal;
    const double slip = tangent_speed(c, a, b);
    const double tangent = std::clamp(c.tangent - c.tangent_mass * slip, -most, most);
    return std::max(along_normal, std::abs(tangent - c.tangent) / c.tangent_mass);
}
/// The same of the worst one.  [m/s]
[[nodiscard]] double worst_residual(std::span<const ContactPoint> points, std::span<const Mover> movers);
/// None asks for more than `tolerance`.  [m/s]
[[nodiscard]] bool are_satisfied(std::span<const ContactPoint> points, std::span<const Mover> movers, double tolerance);

/// One sweep over all points in their order: each in turn takes the impulse with which it alone would be content, the
/// normal first, then the friction in Coulomb's cone (projected Gauss-Seidel). What batches do to many points at once,
/// done plainly.
void sweep(std::span<ContactPoint> points, std::span<Mover> movers);

} // namespace flying
