#include "window/main_window.hpp"

#include <gdk/gdk.h>
#include <gdkmm/frameclock.h>
#include <gtkmm/eventcontrollerkey.h>
#include <gtkmm/settings.h>

#include <algorithm>
#include <cctype>

#include "play/keys.hpp"
#include "window/seconds.hpp"

namespace flying {

namespace {

/// A key as `press` names it.
std::string key_name(unsigned value, Gdk::ModifierType modifiers)
{
    const char* name = gdk_keyval_name(gdk_keyval_to_lower(value));
    if (!name) return {};
    std::string text = name;
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto has = [&](Gdk::ModifierType modifier) { return (modifiers & modifier) == modifier; };
    if (has(Gdk::ModifierType::SHIFT_MASK)) text.insert(0, "shift+");
    if (has(Gdk::ModifierType::ALT_MASK)) text.insert(0, "alt+");
    if (has(Gdk::ModifierType::CONTROL_MASK)) text.insert(0, "ctrl+");
    return text;
}

} // namespace

MainWindow::MainWindow(Stage& stage, const WindowOptions& options) : stage_(stage), options_(options), canvas_(stage)
{
    set_title("Flying Polygons");
    set_default_size(options.width, options.height);
    set_child(canvas_);
    listen_to_keys();
    canvas_.add_tick_callback([this](const Glib::RefPtr<Gdk::FrameClock>& clock) {
        return tick(static_cast<double>(clock->get_frame_time()) * 1e-6);
    });
    canvas_.grab_focus();
}

void MainWindow::listen_to_keys()
{
    auto keys = Gtk::EventControllerKey::create();
    keys->signal_key_pressed().connect(
        [this](guint value, guint, Gdk::ModifierType modifiers) { return key(value, modifiers); }, true);
    add_controller(keys);
}

bool MainWindow::key(unsigned value, Gdk::ModifierType modifiers)
{
    const bool was_used = press(stage_, key_name(value, modifiers));
    touch();
    return was_used;
}

void MainWindow::touch()
{
    is_stale_ = true;
    if (stage_.wants_to_quit) close();
}

bool MainWindow::tick(double frame_time)
{
    const double wall = last_frame_ < 0.0 ? 0.0 : std::max(0.0, frame_time - last_frame_);
    last_frame_ = frame_time;
    const double shown_until = std::max(stage_.notice.until, stage_.mode_until);
    const bool was_shown = stage_.now <= shown_until;
    stage_.advance(wall, seconds_now);
    if (is_stale_ || !stage_.clock.is_paused || was_shown) canvas_.queue_draw();
    is_stale_ = false;
    return true;
}

} // namespace flying
