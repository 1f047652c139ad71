#pragma once

#include <limits>

#include "math/vec2.hpp"

using flying::Vec2;

/// When the disc first touches the segment, or infinity.   [s]
inline double first_touch(const Vec2& x, const Vec2& v, double radius, const Vec2& p, const Vec2& q)
{
    (void)x, (void)v, (void)radius, (void)p, (void)q;
    return std::numeric_limits<double>::infinity(); // your code here
}
