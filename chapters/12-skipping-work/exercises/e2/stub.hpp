#pragma once

#include "math/vec2.hpp"

/// Whether two bodies in straight flight may come within `reach` of each other, from now on.
/// offset  from one centre to the other, longer than `reach` [m]
/// velocity  of the other, seen from the one [m/s]
inline bool can_meet(const flying::Vec2& offset, const flying::Vec2& velocity, double reach)
{
    (void)offset, (void)velocity, (void)reach;
    return true; // safe, but it leaves nothing out: your code here
}
