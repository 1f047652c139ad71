#pragma once

#include <utility>

#include "rest/island_solver.hpp"
#include "rest/narrow_phase.hpp"
#include "rest/pair_list.hpp"
#include "rest/rest_bodies.hpp"
#include "rest/rest_options.hpp"
#include "rest/step_motion.hpp"

namespace flying {

/// What the stages of a step share: bodies, how they move, and what they bear on each other. Each stage keeps what it
/// needs for its own work to itself.
struct RestData
{
    RestData(const RestOptions& how, RestBodies who)
        : options(how), bodies(std::move(who)), motion(bodies, options.step), looks(bodies)
    {
        solver.set_warm(options.warm_starts);
    }

    RestOptions options;
    RestBodies bodies;
    StepMotion motion;
    PairList pairs;
    NarrowPhase looks;
    IslandSolver solver;
    RestCounts counts;
    double max_overlap = 0.0; ///< the deepest that any step has begun with [m]
};

/// The points at which a pair touches or might soon touch, with the two bodies at these poses.
/// margin  points further apart than this make no contact [m]
[[nodiscard]] inline Manifold look(const RestData& data, const RestPair& pair, const Pose& pose_a, const Pose& pose_b,
                                   double margin)
{
    return data.looks.look(data.bodies, data.pairs, pair, pose_a, pose_b, margin);
}

} // namespace flying
