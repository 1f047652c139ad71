#pragma once

#include "math/vec2.hpp"

struct PlaceAndVelocity
{
    flying::Vec2 x;
    flying::Vec2 v;
};

/// One step of length h under the acceleration a(x).
template <typename Acceleration>
PlaceAndVelocity runge_kutta(const flying::Vec2& x, const flying::Vec2& v,
                             const Acceleration& a, double h)
{
    (void)a, (void)h;
    return {x, v}; // your code here
}
