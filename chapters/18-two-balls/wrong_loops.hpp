#pragma once

#include "few.hpp"

namespace flying {

/// WRONG, and it looks right: what was foreseen happens, unless the two part already.
inline void run_all_foreseen(Few& few, double until)
{
    for (int k = 0; k < static_cast<int>(few.discs.size()); ++k) few.foresee(k);
    while (!few.queue.empty() && few.queue.top().time <= until) {
        const Foreseen next = few.queue.top();
        few.queue.pop();
        const discs::Disc p = at_time(few.discs[next.a], next.time);
        const discs::Disc q = at_time(few.discs[next.b], next.time);
        const double along = (q.x - p.x) * (q.vx - p.vx) + (q.y - p.y) * (q.vy - p.vy);
        if (along >= 0.0) continue;
        few.strike(next);
        few.foresee(next.a);
        few.foresee(next.b);
    }
}

/// How far a ball came that falls again and again.
struct Hops
{
    long count = 0;
    double time = 0.0;  ///< [s]
    double speed = 0.0; ///< of the last rebound [m/s]
};

/// WRONG, and it looks right: fly to the next impact, bounce, until the time is up.
/// speed  of the first rebound; patience  hops until we give up
inline Hops hop_until(double until, double speed, double e, double g, long patience)
{
    Hops hops{0, 0.0, speed};
    while (hops.time < until && hops.count < patience) {
        hops.time += 2.0 * hops.speed / g;
        hops.speed *= e;
        ++hops.count;
    }
    return hops;
}

} // namespace flying
