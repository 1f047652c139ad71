#pragma once

#include <gtkmm/applicationwindow.h>
#include <gtkmm/box.h>
#include <gtkmm/eventcontroller.h>
#include <gtkmm/filechoosernative.h>

#include <map>
#include <string>

#include "window/canvas.hpp"
#include "window/panel.hpp"
#include "window/recorder.hpp"
#include "window/window.hpp"

namespace flying {

/// The window: hands what the user does to the stage, lets time pass, and does what only a window can.
class MainWindow : public Gtk::ApplicationWindow
{
public:
    MainWindow(Stage& stage, const WindowOptions& options);

private:
    void listen_to_keys();
    void listen_to_pointer();
    void listen_to_drops();
    /// The pointer is at this place of the canvas, by the event that the controller is handling.
    void point(const Gtk::EventController& controller, const Vec2& pixel);
    [[nodiscard]] bool tick(double frame_time);
    [[nodiscard]] bool key(unsigned value, Gdk::ModifierType modifiers);
    [[nodiscard]] bool scroll(double dx, double dy, Gdk::ModifierType modifiers);
    void resized(int width, int height);
    /// Something may have changed: draw, and bring controls up to it.
    void touch();
    void answer_requests();
    void answer(Request request);

    void choose_scene(int index);
    void open_path(const std::string& path);
    /// name  its path, or the name of its kind;  words  what the list of scenes calls it
    void play_scene(Expected<Scene> scene, const std::string& name, const std::string& words);
    void load_face(const std::string& path);
    void save_scene(const std::string& path);
    /// What is still being recorded when the window goes becomes whole; what has become of it is printed.
    void end_recordings();
    void report(const Expected<std::string>& outcome);
    void ask_for_file(const char* title, Gtk::FileChooser::Action action, const char* pattern,
                      std::function<void(const std::string&)> act);

    Stage& stage_;
    WindowOptions options_;
    std::string scene_words_; ///< what the list of scenes calls the one that is played
    Gtk::Box row_{Gtk::Orientation::HORIZONTAL, 0};
    Canvas canvas_;
    Panel panel_;
    Recorder recorder_;
    std::map<std::string, Glib::RefPtr<Gtk::FileChooserNative>> choosers_; ///< of files, by their titles
    Vec2 dragged_ = Vec2::Zero();                                          ///< by the middle button, so far [pixels]
    int width_ = 0; ///< of the canvas when it was last resized [pixels]
    int height_ = 0;
    double last_frame_ = -1.0; ///< [s]
    double synced_ = 0.0;      ///< when controls were last brought up to the stage [s]
    bool is_stale_ = true;     ///< the canvas shows less than the stage knows
};

} // namespace flying
