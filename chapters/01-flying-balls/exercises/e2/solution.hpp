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
    using flying::Vec2;
    const double half = 0.5 * h;
    const Vec2 v_1 = v;
    const Vec2 a_1 = a(x);
    const Vec2 v_2 = v + half * a_1;
    const Vec2 a_2 = a(Vec2(x + half * v_1));
    const Vec2 v_3 = v + half * a_2;
    const Vec2 a_3 = a(Vec2(x + half * v_2));
    const Vec2 v_4 = v + h * a_3;
    const Vec2 a_4 = a(Vec2(x + h * v_3));
    return {x + (h / 6.0) * (v_1 + 2.0 * v_2 + 2.0 * v_3 + v_4),
            v + (h / 6.0) * (a_1 + 2.0 * a_2 + 2.0 * a_3 + a_4)};
}
