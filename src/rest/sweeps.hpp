#pragma once

#include <span>
#include <vector>

#include "rest/contact_point.hpp"

namespace flying {

/// Apply the impulses that the points already hold, from the step before.
void warm_start(std::span<const ContactPoint> points, std::span<Mover> movers);

void forget_impulses(std::span<ContactPoint> points);

/// How far the worst point is from content: the change of its velocity that it would ask for.  [m/s]
[[nodiscard]] double worst_residual(std::span<const ContactPoint> points, std::span<const Mover> movers);
/// By how much the worst point misses the least normal velocity that it may end with.  [m/s]
[[nodiscard]] double worst_approach(std::span<const ContactPoint> points, std::span<const Mover> movers);
/// None asks for more than `tolerance`.  [m/s]
[[nodiscard]] bool are_satisfied(std::span<const ContactPoint> points, std::span<const Mover> movers, double tolerance);

/// The part of a point that sweeps go over, again and again: small, so that many fit where the processor reaches them
/// fast.
struct SweepPoint
{
    int a;
    int b;
    double n_x;
    double n_y;
    double normal_arm_a;
    double normal_arm_b;
    double tangent_arm_a;
    double tangent_arm_b;
    double normal_mass;
    double tangent_mass;
    double friction;
    double bound;
    double normal;
    double tangent;
};

[[nodiscard]] SweepPoint sweep_point(const ContactPoint& c);

/// One sweep over all points in their order: each in turn takes the impulse with which it alone would be content, the
/// normal first, then the friction in Coulomb's cone (projected Gauss-Seidel).
void sweep(std::span<SweepPoint> points, std::span<Mover> movers);

/// The same, in the opposite order.
void sweep_back(std::span<SweepPoint> points, std::span<Mover> movers);

} // namespace flying
