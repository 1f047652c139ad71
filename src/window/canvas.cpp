#include "window/canvas.hpp"

#include <algorithm>

#include "play/paint_stage.hpp"
#include "play/seconds.hpp"

namespace flying {

Canvas::Canvas(Stage& stage) : stage_(stage)
{
    set_expand(true);
    set_focusable(true);
    set_content_width(320);
    set_content_height(240);
    set_draw_func(
        [this](const Cairo::RefPtr<Cairo::Context>& context, int width, int height) { draw(context, width, height); });
}

Canvas::~Canvas()
{
    for (cairo_surface_t* surface : surfaces_) cairo_surface_destroy(surface);
}

void Canvas::draw(const Cairo::RefPtr<Cairo::Context>& context, int width, int height)
{
    const double started = seconds_now();
    width = std::max(width, 1);
    height = std::max(height, 1);
    last_ = 1 - last_;
    cairo_surface_t*& surface = surfaces_[last_];
    if (!surface || cairo_image_surface_get_width(surface) != width ||
        cairo_image_surface_get_height(surface) != height) {
        cairo_surface_destroy(surface);
        surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    }
    stage_.size = {width, height};
    paint_stage(surface, stage_, stage_.size, usual_bands());
    cairo_set_source_surface(context->cobj(), surface, 0.0, 0.0);
    cairo_paint(context->cobj());
    stage_.clock.drawing = seconds_now() - started;
}

} // namespace flying
