#pragma once

#include <vector>

#include "math/vec2.hpp"

struct Disc
{
    flying::Vec2 position; ///< [m]
    flying::Vec2 velocity; ///< [m/s]
    double radius = 0.5;   ///< [m]
    bool leans = false;
};

/// Numbers of the flyers that must be taken in for a step, ascending.
/// d  length of the step [s]
inline std::vector<int> taken_in(const std::vector<Disc>& discs, double d)
{
    (void)d;
    std::vector<int> all;
    for (int k = 0; k < static_cast<int>(discs.size()); ++k) {
        if (!discs[k].leans) all.push_back(k);
    }
    return all; // safe, but it takes in every flyer: your code here
}
