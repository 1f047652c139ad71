#pragma once

#include "play/stage.hpp"

namespace flying {

/// Draw the stage, all of a surface of this size: bodies, layers, and what is written over them.
/// cairo  fresh or restored to its initial transformation; its state comes back as it was
void paint_stage(cairo_t* cairo, const Stage& stage, SurfaceSize size);

/// How points of the world lie on that surface.
[[nodiscard]] ViewMap stage_map(const Stage& stage, SurfaceSize size);

/// The theme of the stage's look.
[[nodiscard]] Theme stage_theme(const Stage& stage);

} // namespace flying
