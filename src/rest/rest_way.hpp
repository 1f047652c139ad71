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

/// Of a step, or a part of one, that has been found: goes as much of it as lasts so long [s]. Where bodies move by the
/// mean of their velocities, the way is smooth, and velocities are its slope; in flight it is a parabola.
void go_along(StepMotion& motion, const Island& island, double time);

} // namespace flying
