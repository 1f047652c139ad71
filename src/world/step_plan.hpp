#pragma once

#include <span>
#include <vector>

#include "events/event_engine.hpp"
#include "motion/field.hpp"
#include "rest/rest_engine.hpp"
#include "world/hand_over.hpp"
#include "world/movers.hpp"

namespace flying {

/// Bodies as they are when a step begins, and what moves them.
struct StepStart
{
    const EventEngine& flying;
    const RestEngine& resting; ///< at whose time the step begins
    const Movers& movers;
    std::span<const double> radius; ///< of bounding circles, by body [m]
    const Field& field;
    double step = 0.0; ///< length of a whole step [s]
};

/// What the rules of handing over need to know of bodies that lean.
[[nodiscard]] std::vector<Leaning> leaning_among(std::span<const int> bodies, const StepStart& start);

/// The step that comes next.
struct StepPlan
{
    double end = 0.0;                    ///< [s]
    std::vector<std::vector<int>> taken; ///< those that fly until now and are taken in, in rounds; each ascending
};

/// Finds every body that may meet one that leans before the step ends, and again those that may meet these. How long
/// the step may be follows from the fastest of them all.
///
/// hand_over  which has just begun with those that lean; afterwards it knows of those that are taken in as well
[[nodiscard]] StepPlan plan_step(const StepStart& start, HandOver& hand_over);

} // namespace flying
