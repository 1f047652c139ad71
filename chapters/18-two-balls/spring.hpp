#pragma once

#include <cmath>

#include "discs.hpp"

namespace flying {

/// An impact that takes time: while two discs overlap, a spring between them pushes. On the
/// way out it is e^2 times as stiff, so that it gives back this share of the work. By small
/// steps of Verlet's; the law of the push is not used.
///
/// stiffness  of the spring [N/m]; h  length of a step [s]
inline void strike_with_spring(discs::Disc& a, discs::Disc& b, double e, double stiffness,
                               double h)
{
    const auto push = [&](double time) {
        const double x = b.x - a.x, y = b.y - a.y;
        const double distance = std::sqrt(x * x + y * y);
        const double overlap = a.r + b.r - distance;
        if (overlap <= 0.0) return;
        const bool parts = (b.vx - a.vx) * x + (b.vy - a.vy) * y > 0.0;
        const double share = parts ? e * e : 1.0;
        const double j = share * stiffness * overlap * time / distance;
        a.vx -= j / a.m * x, a.vy -= j / a.m * y;
        b.vx += j / b.m * x, b.vy += j / b.m * y;
    };
    const auto fly = [&](discs::Disc& d) { d.x += h * d.vx, d.y += h * d.vy; };
    do {
        push(0.5 * h);
        fly(a), fly(b);
        push(0.5 * h);
    } while (std::hypot(b.x - a.x, b.y - a.y) < a.r + b.r);
}

} // namespace flying
