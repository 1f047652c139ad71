#pragma once

namespace flying {

/// Impulse along the normal that ends an approach without friction, by Newton's law.  [N s]
///
/// v_n  normal speed of B relative to A, negative when approaching                     [m/s]
/// w_n  speed gained per N s; for two discs the sum of their inverse masses, > 0       [1/kg]
/// e    restitution, 0 ... 1                                                           [-]
[[nodiscard]] constexpr double newton_impulse(double v_n, double w_n, double e)
{
    // Leave what separates alone: contact pushes, it never pulls. Nor do two immovable bodies
    // have an answer
    if (!(v_n < 0.0) || !(w_n > 0.0)) return 0.0;

    return -(1.0 + e) * v_n / w_n;
}

} // namespace flying
