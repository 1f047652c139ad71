#pragma once

// When a parabola falls through zero, and from when to when a straight path lies within a circle.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/vec2.hpp"

namespace flying {

/// The time of what doesn't happen.
inline constexpr double k_never = std::numeric_limits<double>::infinity();

/// The next double after `x`; x finite and not negative.
[[nodiscard]] inline double next_after(double x)
{
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x + 0.0) + 1);
}

/// When f + f_rate t + bend t^2 / 2 falls through zero: the root at which the rate is
/// negative; never negative itself for f >= 0, and infinite where there is no such root.
/// [unit of time]
[[nodiscard]] inline double falling_root(double f, double f_rate, double bend)
{
    const double discriminant = f_rate * f_rate - 2.0 * bend * f;
    if (discriminant < 0.0) return k_never;
    const double root = std::sqrt(discriminant);

    // The rate at the root is -root: of the two forms, take the one that adds equal signs
    if (f_rate <= 0.0) {
        const double denominator = root - f_rate;
        if (denominator > 0.0) return 2.0 * f / denominator;
        return bend < 0.0 ? 0.0 : k_never; // at rest on zero: it falls at once, or stays
    }
    return bend < 0.0 ? (f_rate + root) / -bend : k_never;
}

/// From when to when a point on a straight path lies within a circle about the origin.
/// Empty: `enter` is infinite.
struct Passage
{
    double enter = k_never; ///< [s] from now; negative where the point is inside already
    double leave = -k_never; ///< [s] from now
};

/// x  where the point is now [m]; v  its velocity [m/s]; radius  of the circle, >= 0 [m]
///
/// |x + v t|^2 = radius^2 is a quadratic in t. Its discriminant v^2 radius^2 - (x x v)^2 is
/// taken as a product, for the usual b^2 - 4ac loses every digit of a glancing path.
[[nodiscard]] inline Passage passage_through_circle(const Vec2& x, const Vec2& v, double radius)
{
    const double v2 = v.dot(v);
    const double outside = x.dot(x) - radius * radius;
    if (v2 == 0.0) return outside <= 0.0 ? Passage{-k_never, k_never} : Passage{};

    const double miss = std::abs(cross(x, v));
    const double reach = std::sqrt(v2) * radius;
    const double discriminant = (reach - miss) * (reach + miss);
    if (!(discriminant >= 0.0)) return {};

    const double b = x.dot(v);
    const double root = std::sqrt(discriminant);
    if (b < 0.0) return {outside / (root - b), (root - b) / v2};
    return {-(root + b) / v2, -outside / (root + b)};
}

} // namespace flying
