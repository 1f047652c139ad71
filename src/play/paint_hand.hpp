#pragma once

#include "play/stage.hpp"

namespace flying {

/// What the hand does: the body that is chosen, the line by which one is held, what a click would add, the drawing, the
/// crosshair, and what there is to know about the chosen body.
void paint_hand(cairo_t* cairo, const Stage& stage, SurfaceSize size, const ViewMap& map, const Theme& theme);

} // namespace flying
