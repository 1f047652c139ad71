#pragma once

#include <cmath>

#include "math/vec2.hpp"

/// Whether two bodies in straight flight may come within `reach` of each other, from now on.
/// offset  from one centre to the other, longer than `reach` [m]
/// velocity  of the other, seen from the one [m/s]
inline bool can_meet(const flying::Vec2& offset, const flying::Vec2& velocity, double reach)
{
    // A pair that parts, or keeps its distance, never comes nearer
    if (offset.dot(velocity) >= 0.0) return false;

    // The line passes at |offset x velocity| / |velocity|; err to the side of looking
    constexpr double k_room = 1.0 + 1e-12;
    const double miss = std::abs(flying::cross(offset, velocity));
    return miss <= k_room * reach * velocity.norm();
}
