#pragma once

#include "math/vec2.hpp"

/// Three ways to push a body along in small steps. `a` is a function: the acceleration at a
/// place.
namespace flying::steps {


/// What a step starts from and what it leaves.
struct Moving
{
    Vec2 x; ///< place [m]
    Vec2 v; ///< velocity [m/s]
};



/// Explicit Euler: place and velocity go on as they were when the step began.
/// h  length of the step [s]
template <typename Acceleration>
[[nodiscard]] Moving euler(const Moving& b, const Acceleration& a, double h)
{
    return {b.x + h * b.v, b.v + h * a(b.x)};
}



/// Symplectic Euler: the velocity goes first, and the place goes on at the new one.
template <typename Acceleration>
[[nodiscard]] Moving symplectic_euler(const Moving& b, const Acceleration& a, double h)
{
    const Vec2 v = b.v + h * a(b.x);
    return {b.x + h * v, v};
}



/// Velocity Verlet: half of the push, the whole way, the other half of the push.
template <typename Acceleration>
[[nodiscard]] Moving verlet(const Moving& b, const Acceleration& a, double h)
{
    const Vec2 v_middle = b.v + (0.5 * h) * a(b.x);
    const Vec2 x = b.x + h * v_middle;
    return {x, v_middle + (0.5 * h) * a(x)};
}



/// n steps of length h, one after the other.
template <typename Step, typename Acceleration>
[[nodiscard]] Moving run(const Step& step, Moving b, const Acceleration& a, double h,
                         long n)
{
    for (long k = 0; k < n; ++k) b = step(b, a, h);
    return b;
}


/// The steppers as things that can be handed over.
inline constexpr auto k_euler = [](const Moving& b, const auto& a, double h) {
    return euler(b, a, h);
};
inline constexpr auto k_symplectic = [](const Moving& b, const auto& a, double h) {
    return symplectic_euler(b, a, h);
};
inline constexpr auto k_verlet = [](const Moving& b, const auto& a, double h) {
    return verlet(b, a, h);
};

} // namespace flying::steps
