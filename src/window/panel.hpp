#pragma once

#include <functional>
#include <string>
#include <vector>

#include <gtkmm/scrolledwindow.h>

#include "play/stage.hpp"
#include "window/controls.hpp"
#include "window/panel_parts.hpp"

namespace flying {

/// The controls beside the stage: each shows what the stage knows, and changes it.
class Panel : public Gtk::ScrolledWindow
{
public:
    /// scenes   paths of scenes to choose from; what can be generated comes after them
    /// touched  called after any control has changed the stage
    /// chosen   called with the number of the scene that is chosen
    Panel(Stage& stage, const std::vector<std::string>& scenes, std::function<void()> touched,
          std::function<void(int)> chosen);

    /// Bring all controls up to the stage.
    void sync(bool is_filming, bool is_tracing);
    /// Where the controls are, as JSON by their names: {"Pause": [x, y], ...}, for a program that plays.
    /// within  the widget whose pixels these are
    [[nodiscard]] std::string places(Gtk::Widget& within) const { return controls_.places(within); }
    /// The scene that is shown as chosen, as `ScenePart::show` has it.
    void show_scene(const std::string& scene, const std::string& words);

private:
    /// A key that is to work the control with the focus: true where that must be brought in sight first, and is worked
    /// then.
    [[nodiscard]] bool key(unsigned value);
    /// The control with the focus; null where that isn't one of these, or is in a list that has dropped down.
    [[nodiscard]] Gtk::Widget* focus();
    [[nodiscard]] bool is_in_sight(Gtk::Widget& control);

    Stage& stage_;
    Controls controls_;
    // In this order they stand in the column
    ScenePart scene_;
    TimePart time_;
    WorldPart world_;
    HandPart hand_;
    LookPart look_;
    RecordPart record_;
};

} // namespace flying
