#include "window/main_window.hpp"

#include <fmt/format.h>
#include <gdk/gdk.h>
#include <gdkmm/frameclock.h>
#include <gtkmm/eventcontrollerkey.h>
#include <gtkmm/settings.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>

#include "files/interrupt.hpp"
#include "play/keys.hpp"
#include "play/seconds.hpp"
#include "scene/fault.hpp"

namespace flying {

namespace {

constexpr double k_sync_every = 0.2; ///< [s]
constexpr int k_narrow = 760;        ///< less wide, controls would take more room than what they control [pixels]

bool has(Gdk::ModifierType modifiers, Gdk::ModifierType one)
{
    return (modifiers & one) == one;
}

/// A key as `press` names it.
std::string key_name(unsigned value, Gdk::ModifierType modifiers)
{
    const char* name = gdk_keyval_name(gdk_keyval_to_lower(value));
    if (!name) return {};
    std::string text = name;
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (has(modifiers, Gdk::ModifierType::SHIFT_MASK)) text.insert(0, "shift+");
    if (has(modifiers, Gdk::ModifierType::ALT_MASK)) text.insert(0, "alt+");
    if (has(modifiers, Gdk::ModifierType::CONTROL_MASK)) text.insert(0, "ctrl+");
    return text;
}

} // namespace

MainWindow::MainWindow(Stage& stage, const WindowOptions& options)
    : stage_(stage),
      options_(options),
      canvas_(stage),
      panel_(
          stage, options.scenes, [this] { touch(); }, [this](int index) { choose_scene(index); })
{
    set_title("Flying Polygons: " + options.scene);
    set_default_size(options.width, options.height);
    row_.append(canvas_);
    row_.append(panel_);
    set_child(row_);
    panel_.set_visible(options.has_panel && options.width >= k_narrow);
    if (options.has_panel && options.width < k_narrow) stage_.say("F9 shows the controls, F1 all keys");
    scene_words_ = std::filesystem::path(options.scene).stem().string();
    panel_.show_scene(options.scene, scene_words_);
    if (!options.face.empty()) load_face(options.face);

    listen_to_keys();
    listen_to_pointer();
    listen_to_drops();
    canvas_.signal_resize().connect([this](int width, int height) { resized(width, height); });
    canvas_.add_tick_callback([this](const Glib::RefPtr<Gdk::FrameClock>& clock) {
        return tick(static_cast<double>(clock->get_frame_time()) * 1e-6);
    });
    signal_close_request().connect(
        [this] {
            end_recordings();
            return false;
        },
        false);
    canvas_.grab_focus();
    touch();
}

void MainWindow::end_recordings()
{
    // The window can show nothing any more
    for (const Expected<std::string>& outcome : recorder_.finish()) {
        if (outcome) fmt::print("{}\n", outcome.value());
        else fmt::print(stderr, "{}\n", format_fault(outcome.faults().front()));
    }
}

void MainWindow::listen_to_keys()
{
    // The canvas takes its keys first; what controls leave over comes to the window
    for (Gtk::Widget* widget : {static_cast<Gtk::Widget*>(&canvas_), static_cast<Gtk::Widget*>(this)}) {
        auto keys = Gtk::EventControllerKey::create();
        keys->signal_key_pressed().connect(
            [this](guint value, guint, Gdk::ModifierType modifiers) { return key(value, modifiers); }, true);
        widget->add_controller(keys);
    }
}

bool MainWindow::key(unsigned value, Gdk::ModifierType modifiers)
{
    const bool was_used = press(stage_, key_name(value, modifiers));
    if (was_used && value == GDK_KEY_Escape) canvas_.grab_focus();
    touch();
    return was_used;
}

bool MainWindow::tick(double frame_time)
{
    if (interrupted() != 0) {
        close();
        return false;
    }
    const double wall = last_frame_ < 0.0 ? 0.0 : std::max(0.0, frame_time - last_frame_);
    last_frame_ = frame_time;
    const double shown_until = std::max({stage_.notice.until, stage_.mode_until, stage_.ship.burns_until});
    const bool was_shown = stage_.now <= shown_until;
    stage_.advance(wall, seconds_now);
    const bool is_busy = is_stale_ || !stage_.clock.is_paused || was_shown || stage_.hand.grip;
    if (is_busy) canvas_.queue_draw();
    is_stale_ = false;
    if (!stage_.clock.is_paused || is_busy) {
        if (const std::optional<Fault> fault = recorder_.add(stage_, canvas_.surface(), wall))
            stage_.say("Recording ended: " + fault->found, true);
    }
    if (stage_.now > synced_ + k_sync_every) {
        synced_ = stage_.now;
        panel_.sync(recorder_.is_filming(), recorder_.is_tracing());
    }
    return true;
}

void MainWindow::touch()
{
    is_stale_ = true;
    stage_.refresh();
    answer_requests();
    panel_.sync(recorder_.is_filming(), recorder_.is_tracing());
    const auto settings = Gtk::Settings::get_default();
    if (settings && settings->property_gtk_application_prefer_dark_theme() != stage_.look.is_dark) {
        settings->property_gtk_application_prefer_dark_theme() = stage_.look.is_dark;
    }
}

void MainWindow::resized(int width, int height)
{
    const bool is_known = width_ > 0 && height_ > 0 && width > 0 && height > 0;
    if (is_known && stage_.box_follows && (width != width_ || height != height_)) {
        resize_box(stage_, static_cast<double>(width) / width_, static_cast<double>(height) / height_);
    }
    width_ = width;
    height_ = height;
    is_stale_ = true;
}

} // namespace flying
