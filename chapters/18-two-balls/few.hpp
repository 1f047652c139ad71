#pragma once

#include <algorithm>
#include <cstdint>
#include <queue>
#include <tuple>
#include <vector>

#include "discs.hpp"
#include "math/random.hpp"
#include "math/roots.hpp"
#include "math/vec2.hpp"

namespace flying {

/// A disc as it was at a moment of its own.
struct Clocked
{
    discs::Disc disc;
    double time = 0.0;       ///< when this was so [s]
    std::uint32_t stamp = 0; ///< how often it was pushed
};

/// The disc as it is at time t.
inline discs::Disc at_time(const Clocked& c, double t)
{
    discs::Disc d = c.disc;
    d.x += (t - c.time) * d.vx;
    d.y += (t - c.time) * d.vy;
    return d;
}

/// An impact that will come, if both discs are left alone until then.
struct Foreseen
{
    double time; ///< [s]
    int a, b;
    std::uint32_t stamp; ///< of both discs together, when it was foreseen
};

/// Puts the earlier one first in a queue; at one time, the lower numbers.
struct ComesLater
{
    bool operator()(const Foreseen& p, const Foreseen& q) const
    {
        return std::tie(p.time, p.a, p.b) > std::tie(q.time, q.a, q.b);
    }
};

/// A few discs without walls, and what is foreseen of them.
struct Few
{
    std::vector<Clocked> discs;
    double e = 1.0; ///< restitution
    std::priority_queue<Foreseen, std::vector<Foreseen>, ComesLater> queue;
    std::vector<Foreseen> handled;
    double widest_gap = 0.0; ///< between two discs that were pushed apart [m]

    /// When two discs meet, if both are left alone.
    void foresee_pair(int a, int b)
    {
        const Clocked& p = discs[a];
        const Clocked& q = discs[b];
        const double now = std::max(p.time, q.time);
        const double wait = discs::when_meet(at_time(p, now), at_time(q, now));
        if (wait < k_never) queue.push({now + wait, a, b, p.stamp + q.stamp});
    }

    /// The same for disc `a` and each of the others.
    void foresee(int a)
    {
        for (int b = 0; b < static_cast<int>(discs.size()); ++b) {
            if (a != b) foresee_pair(a, b);
        }
    }

    /// Bring two discs, and no other, to the moment of their impact, and push.
    void strike(const Foreseen& impact)
    {
        Clocked& p = discs[impact.a];
        Clocked& q = discs[impact.b];
        for (Clocked* c : {&p, &q}) {
            c->disc = at_time(*c, impact.time);
            c->time = impact.time;
            ++c->stamp;
        }
        const Vec2 apart(q.disc.x - p.disc.x, q.disc.y - p.disc.y);
        widest_gap = std::max(widest_gap, apart.norm() - (p.disc.r + q.disc.r));
        discs::strike(p.disc, q.disc, e);
        handled.push_back(impact);
    }

    /// From impact to impact, up to a time.  [s]
    void run(double until)
    {
        for (int k = 0; k < static_cast<int>(discs.size()); ++k) foresee(k);
        while (!queue.empty() && queue.top().time <= until) {
            const Foreseen next = queue.top();
            queue.pop();
            if (next.stamp != discs[next.a].stamp + discs[next.b].stamp) continue;
            strike(next);
            foresee(next.a);
            foresee(next.b);
        }
    }
};

/// Equal discs in a square that fly past each other, on the whole towards the middle.
inline Few crowd_of(int side)
{
    Random random(1001);
    Few few;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const Vec2 x(2.0 * column - side + 1.0, 2.0 * row - side + 1.0);
            const double v_x = random.uniform(-0.5, 0.5);
            const double v_y = random.uniform(-0.5, 0.5);
            const Vec2 v = Vec2(v_x, v_y) - 0.2 * x;
            few.discs.push_back({{x.x(), x.y(), v.x(), v.y(), 0.5, 1.0}});
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
    for (const Clocked& c : few.discs) {
        const Vec2 v(c.disc.vx, c.disc.vy);
        sums.momentum += c.disc.m * v;
        sums.energy += 0.5 * c.disc.m * v.squaredNorm();
    }
    return sums;
}

} // namespace flying
