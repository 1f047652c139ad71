#include "window/panel_parts.hpp"

#include <fmt/format.h>
#include <gtkmm/grid.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "play/keys.hpp"
#include "play/panels.hpp"
#include "scene/generate.hpp"

namespace flying {

namespace {

/// What a key does, as an action of a control.
std::function<void()> pressing(Stage& stage, const char* key)
{
    return [&stage, key] { press(stage, key); };
}

} // namespace

ScenePart::ScenePart(Controls& controls, Stage& stage, const std::vector<std::string>& scenes,
                     std::function<void(int)> chosen)
    : scenes_(scenes)
{
    controls.add_heading("Scene");
    std::vector<Glib::ustring> names;
    for (const std::string& path : scenes) names.emplace_back(std::filesystem::path(path).stem().string());
    for (const GeneratorKind& kind : generator_kinds()) names.emplace_back("new: " + kind.name);
    names_ = Gtk::StringList::create(names);
    list_ = &controls.make_list("scene", names_, [this, chosen = std::move(chosen)](unsigned index) {
        const unsigned first = has_own_entry_ ? 1 : 0;
        if (index != GTK_INVALID_LIST_POSITION && index >= first) chosen(static_cast<int>(index - first));
    });
    list_->set_tooltip_text("Scenes to open, and kinds to be generated anew");
    controls.append(*list_);
    Gtk::Box& row = controls.add_row();
    row.append(controls.make_button("Open\u2026", "A scene file (Ctrl+O); or drop one on the window",
                                    pressing(stage, "ctrl+o")));
    row.append(controls.make_button("Save\u2026", "The scene as it is now (Ctrl+S)", pressing(stage, "ctrl+s")));
}

void ScenePart::show(const std::string& scene, const std::string& words)
{
    const auto place = std::find(scenes_.begin(), scenes_.end(), scene);
    const bool is_listed = place != scenes_.end();
    names_->splice(0, has_own_entry_ ? 1 : 0,
                   is_listed ? std::vector<Glib::ustring>{} : std::vector<Glib::ustring>{words});
    has_own_entry_ = !is_listed;
    list_->set_selected(is_listed ? static_cast<guint>(place - scenes_.begin()) : 0);
}

TimePart::TimePart(Controls& controls, Stage& stage)
{
    controls.add_heading("Time");
    Gtk::Box& row = controls.add_row();
    pause_ = &controls.make_toggle(
        "Pause", "P or space", [&stage] { stage.clock.is_paused = true; }, [&stage] { stage.clock.is_paused = false; });
    row.append(*pause_);
    row.append(controls.make_button("\u25c0", "One frame back (comma)", pressing(stage, "comma")));
    row.append(controls.make_button("\u25b6", "One frame on (full stop)", pressing(stage, "period")));
    row.append(controls.make_button("Reset", "To the beginning (Home)", pressing(stage, "home")));
    speed_ = &controls.add_scale("Speed", -8.0, 6.0, 0.25, "Simulated seconds a second (+ and -)",
                                 [&stage](double power) { set_speed(stage, std::exp2(power)); });
    speed_->set_format_value_func([](double power) { return Glib::ustring(speed_text(std::exp2(power))); });
}

void TimePart::sync(const Stage& stage)
{
    pause_->set_active(stage.clock.is_paused);
    speed_->set_value(std::log2(stage.clock.speed));
}

WorldPart::WorldPart(Controls& controls, Stage& stage)
{
    controls.add_heading("World");
    field_ = &controls.make_list("field", Gtk::StringList::create({"no field", "uniform gravity", "central field"}),
                                 [&stage](unsigned index) {
                                     set_field_kind(stage, static_cast<FieldKind>(index));
                                     stage.arrow_keys = ArrowKeys::gravity;
                                     stage.mode_until = stage.now + 3.0;
                                 });
    field_->set_tooltip_text("Shift+G; G and the arrows change its strength");
    controls.append(*field_);
    restitution_ =
        &controls.add_scale("Restitution", 0.0, 1.0, 0.01, "R and the arrows; bodies with one of their own keep it",
                            [&stage](double e) { set_restitution(stage, e); });
    friction_ = &controls.add_scale("Friction", 0.0, 2.0, 0.01, "Bodies with one of their own keep it",
                                    [&stage](double mu) { set_friction(stage, mu); });
    follows_ = &controls.make_check("the box follows the window's size", "follows",
                                    [&stage](bool on) { stage.box_follows = on; });
    controls.append(*follows_);
}

void WorldPart::sync(const Stage& stage)
{
    const WorldDef& world = stage.run.scene().world;
    field_->set_selected(static_cast<guint>(field_kind(world.field)));
    restitution_->set_value(world.restitution);
    friction_->set_value(world.friction);
    follows_->set_active(stage.box_follows);
}

HandPart::HandPart(Controls& controls, Stage& stage)
{
    controls.add_heading("Hand");
    auto* grid = Gtk::make_managed<Gtk::Grid>();
    grid->set_column_homogeneous(true);
    grid->set_column_spacing(5);
    grid->set_row_spacing(5);
    const char* names[] = {"Grab", "Disc", "Polygon", "Draw", "Remove"};
    for (int k = 0; k < k_tools; ++k) {
        const auto tool = static_cast<Tool>(k);
        Gtk::ToggleButton& button = controls.make_toggle(names[k], fmt::format("{} ({})", tool_text(tool), k + 1),
                                                         [&stage, tool] { take_tool(stage, tool); }, {});
        if (k > 0) button.set_group(*tools_[0]);
        tools_[static_cast<std::size_t>(k)] = &button;
        grid->attach(button, k % 3, k / 3);
    }
    undo_ = &controls.make_button("Undo", "Ctrl+Z", pressing(stage, "ctrl+z"));
    grid->attach(*undo_, 0, 2);
    redo_ = &controls.make_button("Redo", "Ctrl+Shift+Z, Ctrl+Y", pressing(stage, "ctrl+y"));
    grid->attach(*redo_, 1, 2);
    controls.append(*grid);
}

void HandPart::sync(const Stage& stage)
{
    tools_[static_cast<std::size_t>(stage.hand.tool)]->set_active(true);
    undo_->set_sensitive(stage.run.can_undo());
    redo_->set_sensitive(stage.run.can_redo());
}

LookPart::LookPart(Controls& controls, Stage& stage)
{
    controls.add_heading("Shown");
    colouring_ = &controls.make_list(
        "colours", Gtk::StringList::create({"colours by number", "random colours", "colours by what moves bodies"}),
        [&stage](unsigned index) { stage.look.colouring = static_cast<Colouring>(index); });
    controls.append(*colouring_);
    auto* grid = Gtk::make_managed<Gtk::Grid>();
    grid->set_column_homogeneous(false);
    grid->set_column_spacing(8);
    for (int k = 0; k < static_cast<int>(k_layers); ++k) {
        const auto layer = static_cast<Layer>(k);
        const std::string text(layer_text(layer));
        Gtk::CheckButton& check = controls.make_check(text, text, [&stage, layer](bool on) {
            if (stage.look.shows(layer) != on) stage.look.toggle(layer);
        });
        layers_[static_cast<std::size_t>(k)] = &check;
        grid->attach(check, k % 2, k / 2);
    }
    const int row = static_cast<int>(k_layers + 1) / 2;
    dark_ = &controls.make_check("dark", "dark", [&stage](bool on) { stage.look.is_dark = on; });
    grid->attach(*dark_, 0, row);
    turn_ = &controls.make_check("faces turn", "faces turn", [&stage](bool on) { stage.look.faces_turn = on; });
    grid->attach(*turn_, 1, row);
    controls.append(*grid);
}

void LookPart::sync(const Stage& stage)
{
    colouring_->set_selected(static_cast<guint>(stage.look.colouring));
    for (std::size_t k = 0; k < k_layers; ++k) layers_[k]->set_active(stage.look.layers[k]);
    dark_->set_active(stage.look.is_dark);
    turn_->set_active(stage.look.faces_turn);
}

RecordPart::RecordPart(Controls& controls, Stage& stage)
{
    controls.add_heading("Record");
    Gtk::Box& row = controls.add_row();
    video_ = &controls.make_button("Video", "Record what is seen, or end it (F6)", pressing(stage, "f6"));
    row.append(*video_);
    trace_ = &controls.make_button("Trace", "Record the motion, or end it (F7)", pressing(stage, "f7"));
    row.append(*trace_);
    row.append(controls.make_button("Face\u2026", "A picture for the balls (Ctrl+F); or drop a PNG on the window",
                                    pressing(stage, "ctrl+f")));
}

void RecordPart::sync(bool is_filming, bool is_tracing)
{
    video_->set_label(is_filming ? "End video" : "Video");
    trace_->set_label(is_tracing ? "End trace" : "Trace");
}

} // namespace flying
