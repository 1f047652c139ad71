#pragma once

#include "math/vec2.hpp"

using flying::Vec2;

/// Where to push the cue ball: a unit vector, or zero where no straight shot does it.
inline Vec2 aim(const Vec2& cue, const Vec2& object, const Vec2& pocket, double radius)
{
    // At the impact the cue ball's centre is two radii behind the object ball, as seen from the pocket
    const Vec2 n = (pocket - object).normalized();
    const Vec2 ghost = object - 2.0 * radius * n;
    const Vec2 way = (ghost - cue).normalized();

    // It must come from behind: with a speed along n
    return way.dot(n) > 0.0 ? way : Vec2(0.0, 0.0);
}
