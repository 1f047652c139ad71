#pragma once

#include <span>

#include "math/vec2.hpp"

namespace flying::corner {


/// The turn a -> b -> c as twice a signed area, rounded at every step. [m^2]
inline double rounded_turn(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const double left = (a.x() - c.x()) * (b.y() - c.y());
    const double right = (a.y() - c.y()) * (b.x() - c.x());
    return left - right;
}



/// WRONG, and it looks right: only the sign is wanted, and a sign is an int.
inline int wrong_turn(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const int turn = static_cast<int>(rounded_turn(a, b, c));
    return (turn > 0 ? 1 : 0) - (turn < 0 ? 1 : 0);
}



/// Some edge of one ring crosses some edge of the other, by the turns that are
/// handed in.
template <typename Turn>
bool rings_cross(std::span<const Vec2> a, std::span<const Vec2> b, Turn turn)
{
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec2& p = a[i];
        const Vec2& q = a[(i + 1) % a.size()];
        for (std::size_t k = 0; k < b.size(); ++k) {
            const Vec2& u = b[k];
            const Vec2& v = b[(k + 1) % b.size()];
            const bool parts_a = turn(u, v, p) * turn(u, v, q) < 0;
            if (parts_a && turn(p, q, u) * turn(p, q, v) < 0) return true;
        }
    }
    return false;
}


} // namespace flying::corner
