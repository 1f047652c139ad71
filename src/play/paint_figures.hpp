#pragma once

#include "play/stage.hpp"

namespace flying {

/// Figures and curves over the scene: strips of energy and momentum, what a frame costs, what the plan skips, and what the
/// colours of bodies mean.
void paint_figures(cairo_t* cairo, const Stage& stage, SurfaceSize size, const Theme& theme);

} // namespace flying
