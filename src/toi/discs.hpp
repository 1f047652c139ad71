#pragma once

#include <algorithm>
#include <cmath>

#include "math/roots.hpp"
#include "math/vec2.hpp"

namespace flying {

/// When two discs meet that fly under the same acceleration: the smaller root of a
/// quadratic, for discs that approach.  [s] from now; infinite where they don't meet
///
/// offset  from B's centre to A's [m]; rate  velocity of A relative to B [m/s]
/// reach   sum of the radii [m]
[[nodiscard]] inline double time_to_meet(const Vec2& offset, const Vec2& rate, double reach)
{
    // Leave discs alone that part: a gap of zero after an impact is no new one
    const double approach = -offset.dot(rate);
    if (approach <= 0.0) return k_never;

    // The discriminant as a product: b^2 - v^2 c loses every digit of a glancing path
    const double speed2 = rate.dot(rate);
    const double miss = std::abs(cross(offset, rate));
    const double span = std::sqrt(speed2) * reach;
    const double discriminant = (span - miss) * (span + miss);
    if (!(discriminant >= 0.0)) return k_never;

    const double outside = offset.dot(offset) - reach * reach;
    return std::max(outside / (std::sqrt(discriminant) + approach), 0.0);
}

/// When a height above a wall, a parabola in time, falls through zero.
/// [s] from now; infinite where it doesn't
///
/// height, rate, acceleration  of the disc's lowest point above the wall, along its normal
[[nodiscard]] inline double time_to_fall(double height, double rate, double acceleration)
{
    return falling_root(std::max(height, 0.0), rate, acceleration);
}

} // namespace flying
