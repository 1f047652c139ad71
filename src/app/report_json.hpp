#pragma once

#include <optional>
#include <string>

#include "world/report.hpp"
#include "world/world.hpp"

namespace flying {

/// A number as JSON, with the 17 digits that name a double; null for what is not finite, which JSON can't say.
[[nodiscard]] std::string json_number(double value);

/// A report as JSON text with its line end. Keys: time, engine, events, collisions, handovers (how many),
/// handover_log [{time, to, bodies, reason, ends_bounces, energy_before, energy_after, energy_change}], energy {kinetic,
/// potential, total, initial_total}, energy_changes {impacts, steps, handovers}, momentum, angular_momentum, max_overlap, hash (16 hexadecimal digits), plan,
/// stages {name: {count, seconds}}, wall_seconds, bodies [{name, position, angle, velocity, spin, mass, inertia}]; mass
/// and inertia of a static body are null. Where the run failed also failure {time, bodies, message}, bodies by their
/// number from 0.
///
/// wall_seconds  what the run took  [s]
[[nodiscard]] std::string report_json(const Report& report, double wall_seconds,
                                      const std::optional<RunFailure>& failure);

} // namespace flying
