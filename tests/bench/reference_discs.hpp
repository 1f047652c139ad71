#pragma once

#include <vector>

#include "motion/body.hpp"
#include "world/scene.hpp"

namespace flying::bench {

/// Where frictionless elastic discs in a box without a field really are, as near as 64 bits of mantissa tell: impact by
/// impact in long doubles. Shares no line and no method with the engine: pairs are found by lists of those near by,
/// which are made anew when a disc has gone half the lists' margin from where its own was made.
///
/// scene   discs and nothing else, a box, no field, restitution 1, friction 0
/// time    the moment asked for [s]
/// shift   added to all coordinates, and taken from the answer: what it changes tells how rounding has grown [m]
[[nodiscard]] std::vector<BodyState> reference_discs(const Scene& scene, double time, double shift = 0.0);

/// The scene is one for which `reference_discs` answers.
[[nodiscard]] bool has_reference(const Scene& scene);

} // namespace flying::bench
