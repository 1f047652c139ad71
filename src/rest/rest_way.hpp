#pragma once

#include <optional>
#include <vector>

#include "rest/island.hpp"

namespace flying {

/// Where bodies are within a step, and how they move: what a step would say that had ended there.
struct WithinStep
{
    double since = 0.0;                           ///< since the whole step began [s]
    std::vector<std::optional<BodyState>> states; ///< of each body as it lies in memory; of those that the step moves
};

/// How far its turn in the step may bring any point of a body.  [m]
[[nodiscard]] double arc_of(const RestData& data, int body);
/// How far the step takes any point of it, at most.  [m]
[[nodiscard]] double farthest_way(const RestData& data, int body);

/// Where a body is at a part of its way: 0 at its beginning, 1 at its end.
[[nodiscard]] Pose pose_along(const RestData& data, int body, double part);
/// Takes all bodies of an island to be there.
void set_end_poses(RestData& data, const Island& island, double part);

/// Of a step, or a part of one, that has been found: goes as much of it as lasts so long [s]. Where bodies move by the
/// mean of their velocities, the way is smooth, and velocities are its slope; in flight it is a parabola.
void go_along(StepMotion& motion, const Island& island, double time);

} // namespace flying
