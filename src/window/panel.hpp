#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtkmm/box.h>
#include <gtkmm/button.h>
#include <gtkmm/checkbutton.h>
#include <gtkmm/dropdown.h>
#include <gtkmm/grid.h>
#include <gtkmm/scale.h>
#include <gtkmm/scrolledwindow.h>
#include <gtkmm/stringlist.h>
#include <gtkmm/togglebutton.h>

#include "play/stage.hpp"

namespace flying {

/// The controls beside the stage: each shows what the stage knows, and changes it.
class Panel : public Gtk::ScrolledWindow
{
public:
    /// scenes   paths of scenes to choose from; what can be generated comes after them
    /// touched  called after any control has changed the stage
    /// chosen   called with the number of the scene that is chosen
    Panel(Stage& stage, const std::vector<std::string>& scenes, std::function<void()> touched, std::function<void(int)> chosen);

    /// Bring all controls up to the stage.
    void sync(bool is_filming, bool is_tracing);
    /// Where the controls are, as JSON by their texts: {"Pause": [x, y], ...}, for a program that plays.
    /// within  the widget whose pixels these are
    [[nodiscard]] std::string places(Gtk::Widget& within) const;
    /// The scene that is shown as chosen, by its path. One that the list hasn't got, a file from elsewhere or a scene
    /// generated anew, gets an entry of its own at the top, until another is played.
    ///
    /// words  what that entry says
    void show_scene(const std::string& scene, const std::string& words);

private:
    void add_heading(const char* text);
    Gtk::Box& add_row();
    Gtk::Button& add_button(Gtk::Box& row, const char* text, const char* hint, std::function<void()> act);
    Gtk::Scale& add_scale(const char* text, double low, double high, double step, const char* hint, std::function<void(double)> act);
    Gtk::CheckButton& add_check(int column, int row, const char* text, std::function<void(bool)> act);
    void add_scene_part(const std::vector<std::string>& scenes);
    void add_time_part();
    void add_world_part();
    void add_tool_part();
    void add_look_part();
    void add_record_part();
    /// A key that is to work the control with the focus: true where that must be brought in sight first, and is worked then.
    [[nodiscard]] bool key(unsigned value);
    /// The control with the focus; null where that isn't one of these, or is in a list that has dropped down.
    [[nodiscard]] Gtk::Widget* focus();
    [[nodiscard]] bool is_in_sight(Gtk::Widget& control);
    /// Run an action of the user; not while controls are brought up to the stage.
    void act(const std::function<void()>& action);

    Stage& stage_;
    std::function<void()> touched_;
    std::function<void(int)> chosen_;
    bool is_syncing_ = false;
    std::vector<std::string> scenes_; ///< to choose from, by their paths
    Glib::RefPtr<Gtk::StringList> scene_names_;
    bool has_own_entry_ = false; ///< what is played stands above the scenes
    std::vector<std::pair<std::string, Gtk::Widget*>> controls_; ///< by what is written on them
    Gtk::Box column_{Gtk::Orientation::VERTICAL, 5};
    Gtk::DropDown* scene_ = nullptr;
    Gtk::ToggleButton* pause_ = nullptr;
    Gtk::Scale* speed_ = nullptr;
    Gtk::DropDown* field_ = nullptr;
    Gtk::Scale* restitution_ = nullptr;
    Gtk::Scale* friction_ = nullptr;
    Gtk::CheckButton* follows_ = nullptr;
    std::array<Gtk::ToggleButton*, k_tools> tools_{};
    Gtk::Grid* checks_ = nullptr;
    std::array<Gtk::CheckButton*, k_layers> layers_{};
    Gtk::CheckButton* dark_ = nullptr;
    Gtk::CheckButton* turn_ = nullptr;
    Gtk::DropDown* colouring_ = nullptr;
    Gtk::Button* undo_ = nullptr;
    Gtk::Button* redo_ = nullptr;
    Gtk::Button* video_ = nullptr;
    Gtk::Button* trace_ = nullptr;
};

} // namespace flying
