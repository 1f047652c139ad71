#pragma once

#include <algorithm>
#include <vector>

#include "events/event_queue.hpp"
#include "math/random.hpp"
#include "toi/discs.hpp"

namespace flying {


/// A disc of diameter 1, as it was at a moment of its own.
struct FewDisc
{
    Vec2 x = Vec2::Zero();   ///< [m]
    Vec2 v = Vec2::Zero();   ///< [m/s]
    double time = 0.0;       ///< when this was so [s]
    std::uint32_t stamp = 0; ///< how often it was pushed

    [[nodiscard]] Vec2 place(double t) const { return x + (t - time) * v; }
};


/// A few equal elastic discs without walls, and what is foreseen of them.
struct Few
{
    std::vector<FewDisc> discs;
    EventQueue queue;
    std::vector<Event> handled;
    double widest_gap = 0.0; ///< between two discs that were pushed apart [m]


    /// When disc `a` meets each of the others, if both are left alone.
    void foresee(int a)
    {
        for (int b = 0; b < static_cast<int>(discs.size()); ++b) {
            if (a == b) continue;
            const FewDisc& p = discs[a];
            const FewDisc& q = discs[b];
            const double start = std::max(p.time, q.time);
            const double wait =
                time_to_meet(p.place(start) - q.place(start), p.v - q.v, 1.0);
            if (wait < k_never) queue.push({start + wait, a, b, p.stamp + q.stamp});
        }
    }



    /// Bring two discs, and no other, to the moment of their impact, and push.
    void strike(const Event& event)
    {
        FewDisc& p = discs[event.a];
        FewDisc& q = discs[event.b];
        for (FewDisc* disc : {&p, &q}) {
            disc->x = disc->place(event.time);
            disc->time = event.time;
            ++disc->stamp;
        }
        const double distance = (q.x - p.x).norm();
        widest_gap = std::max(widest_gap, distance - 1.0);
        const Vec2 n = (q.x - p.x) / distance;
        const Vec2 exchanged = n.dot(p.v - q.v) * n;
        p.v -= exchanged;
        q.v += exchanged;
        handled.push_back(event);
    }



    /// From event to event, up to a time.  [s]
    void run(double until)
    {
        for (int k = 0; k < static_cast<int>(discs.size()); ++k) foresee(k);
        while (!queue.empty() && queue.next().time <= until) {
            const Event event = queue.next();
            queue.pop();
            if (event.stamp != discs[event.a].stamp + discs[event.b].stamp) continue;
            strike(event);
            foresee(event.a);
            foresee(event.b);
        }
    }

};

/// Discs in a square that fly past each other, on the whole towards the middle.
inline Few crowd_of(int side)
{
    Random random(1001);
    Few few;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const Vec2 x(2.0 * column - side + 1.0, 2.0 * row - side + 1.0);
            const double v_x = random.uniform(-0.5, 0.5);
            const double v_y = random.uniform(-0.5, 0.5);
            few.discs.push_back({x, Vec2(v_x, v_y) - 0.2 * x});
        }
    }
    return few;
}

/// What a push may not change.
struct FewSums
{
    Vec2 momentum = Vec2::Zero(); ///< [kg m/s]
    double energy = 0.0;          ///< [J]
};

inline FewSums sums_of(const Few& few)
{
    FewSums sums;
    for (const FewDisc& disc : few.discs) {
        sums.momentum += disc.v;
        sums.energy += 0.5 * disc.v.squaredNorm();
    }
    return sums;
}

} // namespace flying
