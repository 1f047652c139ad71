#pragma once

// Which shortcuts the event engine takes; each can be turned off.

#include "broadphase/pair_finder.hpp"

namespace flying {

struct EventEngineOptions
{
    PairFinder pair_finder = PairFinder::grid;
    bool skips_static_pairs = true; ///< static bodies are not compared with each other
    bool skips_far_features = true; ///< turning features wait until bounding circles meet
    bool skips_search = true; ///< movers are predicted and struck from their rows, later events of each wait, no pair
                              ///< is searched for longer than both will fly, and none twice at a time
    bool skips_absent_field = true; ///< where nothing falls, paths are straight
    bool skips_apart_rings = true;  ///< round a centre, rings apart never meet
    bool skips_far_vertices = true; ///< vertices out of reach aren't followed
    /// Say so where an impact leaves a body on another, and when bounces ended that died away.
    bool ends_bounces = false;
    /// Impacts that follow each other faster, where there is next to no room, are crowded.  [s]
    double shortest_bounce = 0.0;
    int most_crowded = 1000;       ///< impacts in a row of one body that leave it no room to move
    double (*seconds)() = nullptr; ///< a clock, lent to measure the stages; null to measure nothing [s]
};

} // namespace flying
