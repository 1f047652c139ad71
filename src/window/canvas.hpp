#pragma once

#include <array>
#include <cstddef>
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
    [[nodiscard]] cairo_surface_t* surface() const { return surfaces_[last_]; }

private:
    void draw(const Cairo::RefPtr<Cairo::Context>& context, int width, int height);

    Stage& stage_;
    /// Two by turns: GTK keeps the last frame's until this one's is shown, and Cairo would copy it before we draw on
    /// it.
    std::array<cairo_surface_t*, 2> surfaces_{};
    std::size_t last_ = 0; ///< drawn on last
};

} // namespace flying
