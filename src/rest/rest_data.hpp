#pragma once

#include <cmath>
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
    RestData(const RestOptions& how, RestBodies what)
        : options(how), whole_step(how.step), bodies(std::move(what)), motion(bodies, options.step), looks(bodies)
    {
        solver.set_warm(options.warm_starts);
    }

    RestOptions options;
    double whole_step; ///< of which length loads are remembered, while `options` say that of the present one [s]
    RestBodies bodies;
    StepMotion motion;
    PairList pairs;
    NarrowPhase looks;
    IslandSolver solver;
    RestCounts counts;
    double max_overlap = 0.0; ///< the deepest that any step has begun with [m]
};

/// How far its turn in the step may bring any point of a body.  [m]
[[nodiscard]] inline double arc_of(const RestData& data, int body)
{
    return std::abs(data.motion.turn[body]) * data.bodies.turning[body];
}

/// How far the step takes any point of it, at most.  [m]
[[nodiscard]] inline double farthest_way(const RestData& data, int body)
{
    return data.motion.shift[body].norm() + arc_of(data, body);
}

/// Where it is at a part of its way: 0 at the beginning, 1 at the end.
[[nodiscard]] inline Pose pose_along(const RestData& data, int body, double part)
{
    const BodyState& s = data.bodies.list[body].state;
    return {s.position + part * data.motion.shift[body], Rotation::of(s.angle + part * data.motion.turn[body])};
}

/// The circles of a pair's two parts come as near to each other as this, with the two bodies at these poses.
/// gap  [m]
[[nodiscard]] inline bool are_near(const RestData& data, const RestPair& pair, const Pose& pose_a, const Pose& pose_b,
                                   double gap)
{
    const ConvexPart& part_a = data.bodies.shapes[pair.a].parts[pair.part_a];
    const ConvexPart& part_b = data.bodies.shapes[pair.b].parts[pair.part_b];
    const double clear = part_a.radius + part_b.radius + gap;
    const Vec2 way =
        (pose_b.position - pose_a.position) + (pose_b.rotation * part_b.centre - pose_a.rotation * part_a.centre);
    return way.squaredNorm() <= clear * clear;
}

/// The points at which a pair touches or might soon touch, with the two bodies at these poses.
/// margin  points further apart than this make no contact [m]
[[nodiscard]] inline Manifold look(const RestData& data, const RestPair& pair, const Pose& pose_a, const Pose& pose_b,
                                   double margin)
{
    return data.looks.look(data.bodies, data.pairs, pair, pose_a, pose_b, margin);
}

} // namespace flying
