#pragma once

#include <optional>
#include <string>

#include "world/report.hpp"
#include "world/world.hpp"

namespace flying {

/// A report as JSON text with its line end, a key on each line, a body on each line. Keys: time, engine, events,
/// collisions, handovers (how many), handover_log [{time, to, bodies, reason, ends_bounces, energy_before,
/// energy_after, energy_change}], energy {kinetic, potential, total, initial_total}, energy_changes {impacts, steps,
/// handovers}, momentum, angular_momentum, max_overlap, hash (16 hexadecimal digits), plan {pair_finder, skips}, stages
/// {name: {count, seconds}}, wall_seconds, bodies [{name, position, angle, velocity, spin, mass, inertia}]; mass and
/// inertia of a static body are null. Where the run failed also failure {time, bodies, message}, bodies by their number
/// from 0. Numbers have the 17 digits that name a double; what is not finite is null, as JSON has no word for it.
///
/// wall_seconds  what the run took  [s]
[[nodiscard]] std::string report_json(const Report& report, double wall_seconds,
                                      const std::optional<RunFailure>& failure);

} // namespace flying
