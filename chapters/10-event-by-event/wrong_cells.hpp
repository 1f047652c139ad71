#pragma once

#include <algorithm>
#include <cmath>

#include "../18-two-balls/few.hpp"

namespace flying {

/// WRONG, and it looks right: after each impact of a disc, look into the nine cells about
/// it.
struct LookAround
{
    double size; ///< of a cell: not smaller than a disc [m]

    void operator()(Few& few, int a, double now) const
    {
        const discs::Disc p = at_time(few.discs[a], now);
        for (int b = 0; b < static_cast<int>(few.discs.size()); ++b) {
            const discs::Disc q = at_time(few.discs[b], now);
            const double columns = std::floor(p.x / size) - std::floor(q.x / size);
            const double rows = std::floor(p.y / size) - std::floor(q.y / size);
            const bool is_near = std::abs(columns) <= 1.0 && std::abs(rows) <= 1.0;
            if (a != b && is_near) few.foresee_pair(a, b);
        }
    }
};

/// How deep the two discs that are deepest in each other are.  [m]
inline double deepest_overlap(const Few& few, double time)
{
    double deepest = 0.0;
    for (std::size_t a = 0; a < few.discs.size(); ++a) {
        const discs::Disc p = at_time(few.discs[a], time);
        for (std::size_t b = 0; b < a; ++b) {
            const discs::Disc q = at_time(few.discs[b], time);
            deepest = std::max(deepest, p.r + q.r - std::hypot(p.x - q.x, p.y - q.y));
        }
    }
    return deepest;
}

/// From impact to impact, with a way to look for the next ones. Returns the deepest overlap
/// found at any impact.  [m]
template <typename Look>
double run_looking(Few& few, double until, const Look& look)
{
    double deepest = 0.0;
    for (int k = 0; k < static_cast<int>(few.discs.size()); ++k) look(few, k, 0.0);
    while (!few.queue.empty() && few.queue.top().time <= until) {
        const Foreseen next = few.queue.top();
        few.queue.pop();
        if (next.stamp != few.discs[next.a].stamp + few.discs[next.b].stamp) continue;
        few.strike(next);
        look(few, next.a, next.time);
        look(few, next.b, next.time);
        deepest = std::max(deepest, deepest_overlap(few, next.time));
    }
    return deepest;
}

} // namespace flying
