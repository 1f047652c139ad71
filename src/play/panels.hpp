#pragma once

#include <string>

#include "play/stage.hpp"

namespace flying {

/// What is written and drawn over the scene: the state of the clock, bars of the mode, the notice, the help.
void paint_panels(cairo_t* cairo, const Stage& stage, SurfaceSize size, const Theme& theme);

/// A speed of time as people say it: "2x", "1/4x".
[[nodiscard]] std::string speed_text(double speed);

} // namespace flying
