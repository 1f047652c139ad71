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
    set_draw_func([this](const Cairo::RefPtr<Cairo::Context>& context, int width, int height) { draw(context, width, height); });
}

Canvas::~Canvas()
{
    cairo_surface_destroy(surface_);
}

void Canvas::draw(const Cairo::RefPtr<Cairo::Context>& context, int width, int height)
{
    const double started = seconds_now();
    width = std::max(width, 1);
    height = std::max(height, 1);
    if (!surface_ || cairo_image_surface_get_width(surface_) != width || cairo_image_surface_get_height(surface_) != height) {
        cairo_surface_destroy(surface_);
        surface_ = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    }
    stage_.size = {width, height};
    cairo_t* cairo = cairo_create(surface_);
    paint_stage(cairo, stage_, stage_.size);
    cairo_destroy(cairo);
    cairo_surface_flush(surface_);
    cairo_set_source_surface(context->cobj(), surface_, 0.0, 0.0);
    cairo_paint(context->cobj());
    stage_.clock.drawing = seconds_now() - started;
}

} // namespace flying
