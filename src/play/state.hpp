#pragma once

#include <string>
#include <string_view>

#include "play/stage.hpp"

namespace flying {

/// All that the stage knows, as JSON text with its line end: time, generation, paused, speed, share, behind, events, collisions, restitution,
/// friction, field {kind, gravity | mu, radius, centre}, box, tool, arrow_keys, selected, holds, pointer, points, sides, size, layers
/// [names], colouring, dark, faces_turn, face, ship {body, heading, thrust, burns}, view, surface, map [pixels a metre, x and y of the origin], costs {simulating,
/// drawing, interval: {median, p95}} [s], notice, can_undo, can_redo, bodies [{name, static, mover, x, y, angle, vx, vy, spin}].
/// more  members besides, as JSON: `"scene":"a.toml"`; may be empty
[[nodiscard]] std::string state_json(const Stage& stage, const std::string& more = {});

/// Text as JSON, in its quotes.
[[nodiscard]] std::string json_text(std::string_view text);

/// A line of a trace as `flying simulate --trace` writes it, at the run's time: {"time": t, "events": n, "bodies": [[x, y,
/// angle, vx, vy, spin], ...]}.
[[nodiscard]] std::string trace_line(const Stage& stage);

} // namespace flying
