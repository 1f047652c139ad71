#pragma once

#include <functional>

#include <cairo.h>
#include <gtkmm/drawingarea.h>

#include "play/stage.hpp"

namespace flying {

/// Where the stage is seen. GTK 4 would record every stroke and draw it later: we draw on a surface of our own and hand
/// over the finished picture.
class Canvas : public Gtk::DrawingArea
{
public:
    explicit Canvas(Stage& stage);
    ~Canvas() override;
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// What was drawn last; null before the first frame.
    [[nodiscard]] cairo_surface_t* surface() const { return surface_; }

private:
    void draw(const Cairo::RefPtr<Cairo::Context>& context, int width, int height);

    Stage& stage_;
    cairo_surface_t* surface_ = nullptr;
};

} // namespace flying
