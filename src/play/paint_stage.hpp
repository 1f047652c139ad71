#pragma once

#include <functional>
#include <thread>

#include "play/stage.hpp"

namespace flying {

/// Draw the stage, all of a surface of this size: bodies, layers, and what is written over them.
/// cairo  fresh or restored to its initial transformation; its state comes back as it was
void paint_stage(cairo_t* cairo, const Stage& stage, SurfaceSize size);

/// Begins a thread that paints one band; std::system_error where the machine has none to give.
using StartThread = std::jthread(const std::function<void(int)>& paint_band, int band);
[[nodiscard]] std::jthread start_thread(const std::function<void(int)>& paint_band, int band);

/// The same on an image of that size, in so many bands, one above the other, by as many threads at once; where one
/// can't be had, the present one paints what is left. What one thread paints differs only at the border of two bands,
/// and there by less than can be seen: edges are rounded where they are cut. image  in memory, RGB24;  bands  1 to 4
void paint_stage(cairo_surface_t* image, const Stage& stage, SurfaceSize size, int bands,
                 StartThread* start = start_thread);
/// As many bands as this machine has processors, four at most.
[[nodiscard]] int usual_bands();

/// How points of the world lie on that surface.
[[nodiscard]] ViewMap stage_map(const Stage& stage, SurfaceSize size);

/// The theme of the stage's look.
[[nodiscard]] Theme stage_theme(const Stage& stage);

} // namespace flying
