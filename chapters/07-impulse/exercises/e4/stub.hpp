#pragma once

#include "math/vec2.hpp"

using flying::Vec2;

/// Where to push the cue ball: a unit vector, or zero where no straight shot does it.
inline Vec2 aim(const Vec2& cue, const Vec2& object, const Vec2& pocket, double radius)
{
    (void)pocket, (void)radius;
    return (object - cue).normalized(); // your code here
}
