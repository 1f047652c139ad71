#pragma once

// What a scene would skip, and why, as text: for `flying explain`.

#include <string>

#include "world/plan.hpp"
#include "world/scene.hpp"

namespace flying {

/// What a skip's `saved` means in a plan.
enum class PlanMoment
{
    before_run,
    after_run
};

/// A plan as text for people, with its line ends: each skip, its class, whether it is active and why, and after a run
/// the work it left out.
[[nodiscard]] std::string explain_plan(const Scene& scene, const Plan& plan, PlanMoment moment);

} // namespace flying
