#pragma once

#include <utility>
#include <vector>

#include "../18-two-balls/billiard.hpp"
#include "balls.hpp"

namespace flying {

/// Galperin's billiard for the engine: a wall on the left, a light ball of 1 kg at rest, a
/// heavy one that comes in at 1 m/s.  ratio  of the two masses
inline EventEngine billiard(double ratio)
{
    std::vector<EventBody> bodies;
    bodies.push_back(ball(0.25, 1.0, {1.0, 0.0}, {0.0, 0.0}));
    bodies.push_back(ball(0.5, ratio, {2.5, 0.0}, {-1.0, 0.0}));
    bodies.push_back(wall({1.0, 0.0}, 0.0));
    return EventEngine(std::move(bodies), {PairFinder::all_pairs});
}

} // namespace flying
