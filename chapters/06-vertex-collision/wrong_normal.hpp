#pragma once

#include "math/vec2.hpp"

namespace flying::corner {


/// WRONG, and it looks right: B lies over there, so it is pushed there.
inline Vec2 wrong_normal(const Vec2& centre_a, const Vec2& centre_b)
{
    return (centre_b - centre_a).normalized();
}



/// A velocity thrown back along a normal, as smooth bodies without loss do.
inline Vec2 bounced(const Vec2& velocity, const Vec2& normal)
{
    return velocity - 2.0 * normal.dot(velocity) * normal;
}


} // namespace flying::corner
