#pragma once

#include <gtkmm/applicationwindow.h>

#include "window/canvas.hpp"
#include "window/window.hpp"

namespace flying {

/// The window: hands what the user does to the stage, and lets time pass.
class MainWindow : public Gtk::ApplicationWindow
{
public:
    MainWindow(Stage& stage, const WindowOptions& options);

private:
    void listen_to_keys();
    [[nodiscard]] bool tick(double frame_time);
    [[nodiscard]] bool key(unsigned value, Gdk::ModifierType modifiers);
    /// Something may have changed: draw, and bring widgets up to it.
    void touch();

    Stage& stage_;
    WindowOptions options_;
    Canvas canvas_;
    double last_frame_ = -1.0; ///< [s]
    bool is_stale_ = true;     ///< the canvas shows less than the stage knows
};

} // namespace flying
