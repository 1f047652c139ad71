#pragma once

// The parts of the panel, from top to bottom. Each adds its controls to the column when it is made; each control
// changes the stage, and `sync` brings it up to the stage, to be called quietly.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "play/stage.hpp"
#include "window/controls.hpp"

namespace flying {

/// Which scene is played.
class ScenePart
{
public:
    /// scenes  paths of scenes to choose from; what can be generated comes after them
    /// chosen  called with the number of the scene that is chosen
    ScenePart(Controls& controls, Stage& stage, const std::vector<std::string>& scenes,
              std::function<void(int)> chosen);
    ScenePart(const ScenePart&) = delete;
    ScenePart& operator=(const ScenePart&) = delete;

    /// The scene that is shown as chosen, by its path. One that the list hasn't got, a file from elsewhere or a scene
    /// generated anew, gets an entry of its own at the top, until another is played.
    ///
    /// words  what that entry says
    void show(const std::string& scene, const std::string& words);

private:
    std::vector<std::string> scenes_; ///< to choose from, by their paths
    Glib::RefPtr<Gtk::StringList> names_;
    bool has_own_entry_ = false; ///< what is played stands above the scenes
    Gtk::DropDown* list_ = nullptr;
};

/// How time runs.
class TimePart
{
public:
    TimePart(Controls& controls, Stage& stage);
    void sync(const Stage& stage);

private:
    Gtk::ToggleButton* pause_ = nullptr;
    Gtk::Scale* speed_ = nullptr;
};

/// What holds for all bodies of the scene.
class WorldPart
{
public:
    WorldPart(Controls& controls, Stage& stage);
    void sync(const Stage& stage);

private:
    Gtk::DropDown* field_ = nullptr;
    Gtk::Scale* restitution_ = nullptr;
    Gtk::Scale* friction_ = nullptr;
    Gtk::CheckButton* follows_ = nullptr;
};

/// The tool of the hand, and what it has done.
class HandPart
{
public:
    HandPart(Controls& controls, Stage& stage);
    void sync(const Stage& stage);

private:
    std::array<Gtk::ToggleButton*, k_tools> tools_{};
    Gtk::Button* undo_ = nullptr;
    Gtk::Button* redo_ = nullptr;
};

/// What is shown, and in which colours.
class LookPart
{
public:
    LookPart(Controls& controls, Stage& stage);
    void sync(const Stage& stage);

private:
    Gtk::DropDown* colouring_ = nullptr;
    std::array<Gtk::CheckButton*, k_layers> layers_{};
    Gtk::CheckButton* dark_ = nullptr;
    Gtk::CheckButton* turn_ = nullptr;
};

/// What is recorded.
class RecordPart
{
public:
    RecordPart(Controls& controls, Stage& stage);
    void sync(bool is_filming, bool is_tracing);

private:
    Gtk::Button* video_ = nullptr;
    Gtk::Button* trace_ = nullptr;
};

} // namespace flying
