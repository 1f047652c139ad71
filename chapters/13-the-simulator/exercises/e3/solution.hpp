#pragma once

#include <algorithm>
#include <vector>

#include "math/vec2.hpp"

struct Disc
{
    flying::Vec2 position; ///< [m]
    flying::Vec2 velocity; ///< [m/s]
    double radius = 0.5;   ///< [m]
    bool leans = false;
};

/// Distance of a point from the segment that begins at x and has the direction and length
/// of w.
inline double distance_to_way(const flying::Vec2& point, const flying::Vec2& x,
                              const flying::Vec2& w)
{
    const double length = w.squaredNorm();
    const double share =
        length > 0.0 ? std::clamp((point - x).dot(w) / length, 0.0, 1.0) : 0.0;
    return (point - (x + share * w)).norm();
}

/// Numbers of the flyers that must be taken in for a step, ascending.
/// d  length of the step [s]
inline std::vector<int> taken_in(const std::vector<Disc>& discs, double d)
{
    std::vector<int> leaning;
    std::vector<int> flying;
    double v = 0.0;
    for (int k = 0; k < static_cast<int>(discs.size()); ++k) {
        (discs[k].leans ? leaning : flying).push_back(k);
        if (discs[k].leans) v = std::max(v, discs[k].velocity.norm());
    }
    std::vector<int> taken;
    for (bool changed = !leaning.empty(); changed;) {
        changed = false;
        for (const int k : flying) {
            const Disc& one = discs[k];
            const bool is_near =
                std::any_of(leaning.begin(), leaning.end(), [&](int other) {
                    const double reach = one.radius + discs[other].radius + 2.0 * v * d;
                    return distance_to_way(discs[other].position, one.position,
                                           d * one.velocity) < reach;
                });
            if (!is_near) continue;
            taken.push_back(k);
            leaning.push_back(k);
            v = std::max(v, one.velocity.norm());
            changed = true;
        }
        std::erase_if(flying, [&](int k) {
            return std::find(taken.begin(), taken.end(), k) != taken.end();
        });
    }
    std::sort(taken.begin(), taken.end());
    return taken;
}
