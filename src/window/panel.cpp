#include "window/panel.hpp"

#include <fmt/format.h>
#include <gdk/gdk.h>
#include <gdkmm/frameclock.h>
#include <gtkmm/adjustment.h>
#include <gtkmm/eventcontrollerkey.h>
#include <gtkmm/label.h>
#include <gtkmm/native.h>
#include <gtkmm/root.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "play/keys.hpp"
#include "play/panels.hpp"
#include "play/state.hpp"
#include "scene/generate.hpp"

namespace flying {

namespace {

constexpr int k_width = 292; ///< [pixels]

Gtk::DropDown* make_choice(const std::vector<Glib::ustring>& names)
{
    return Gtk::make_managed<Gtk::DropDown>(Gtk::StringList::create(names));
}

} // namespace

Panel::Panel(Stage& stage, const std::vector<std::string>& scenes, std::function<void()> touched, std::function<void(int)> chosen)
    : stage_(stage), touched_(std::move(touched)), chosen_(std::move(chosen))
{
    set_policy(Gtk::PolicyType::NEVER, Gtk::PolicyType::AUTOMATIC);
    set_size_request(k_width, -1);
    set_hexpand(false); // its scales would like to
    column_.set_margin(10);
    add_scene_part(scenes);
    add_time_part();
    add_world_part();
    add_tool_part();
    add_look_part();
    add_record_part();
    set_child(column_);
    auto keys = Gtk::EventControllerKey::create();
    keys->set_propagation_phase(Gtk::PropagationPhase::CAPTURE);
    keys->signal_key_pressed().connect([this](guint value, guint, Gdk::ModifierType) { return key(value); }, false);
    add_controller(keys);
}

Gtk::Widget* Panel::focus()
{
    Gtk::Root* root = get_root();
    Gtk::Widget* control = root ? root->get_focus() : nullptr;
    const bool is_ours = control && control->is_ancestor(column_) && control->get_native() == get_native();
    return is_ours ? control : nullptr;
}

bool Panel::is_in_sight(Gtk::Widget& control)
{
    double x = 0.0;
    double y = 0.0;
    return control.translate_coordinates(*this, 0.0, 0.5 * control.get_height(), x, y) && y >= 0.0 && y < get_height();
}

bool Panel::key(unsigned value)
{
    const unsigned working[] = {GDK_KEY_space, GDK_KEY_KP_Space, GDK_KEY_Return, GDK_KEY_ISO_Enter, GDK_KEY_KP_Enter};
    Gtk::Widget* control = focus();
    if (!control || is_in_sight(*control) || std::find(std::begin(working), std::end(working), value) == std::end(working)) return false;

    // Scroll to it first: GTK 4.8 gives a list that drops down beyond the screen's edge a place and a size that it never set.
    // Asked for at each frame: a wheel that turned just before goes on for some frames, and would take the panel back
    add_tick_callback([this, control](const Glib::RefPtr<Gdk::FrameClock>&) {
        if (focus() != control) return false;
        if (is_in_sight(*control)) {
            control->activate();
            return false;
        }
        double x = 0.0;
        double y = 0.0;
        if (!control->translate_coordinates(column_, 0.0, 0.0, x, y)) return false;
        get_vadjustment()->clamp_page(y, y + control->get_height() + 2.0 * column_.get_margin_top());
        return true;
    });
    return true;
}

void Panel::act(const std::function<void()>& action)
{
    if (is_syncing_) return;
    action();
    touched_();
}

void Panel::add_heading(const char* text)
{
    auto* label = Gtk::make_managed<Gtk::Label>();
    label->set_markup(fmt::format("<b>{}</b>", text));
    label->set_xalign(0.0F);
    label->set_margin_top(2);
    column_.append(*label);
}

Gtk::Box& Panel::add_row()
{
    auto* row = Gtk::make_managed<Gtk::Box>(Gtk::Orientation::HORIZONTAL, 5);
    row->set_homogeneous(true);
    column_.append(*row);
    return *row;
}

Gtk::Button& Panel::add_button(Gtk::Box& row, const char* text, const char* hint, std::function<void()> action)
{
    auto* button = Gtk::make_managed<Gtk::Button>(text);
    button->set_tooltip_text(hint);
    button->signal_clicked().connect([this, action = std::move(action)] { act(action); });
    row.append(*button);
    controls_.emplace_back(text, button);
    return *button;
}

Gtk::Scale& Panel::add_scale(const char* text, double low, double high, double step, const char* hint, std::function<void(double)> action)
{
    auto* row = Gtk::make_managed<Gtk::Box>(Gtk::Orientation::HORIZONTAL, 5);
    auto* label = Gtk::make_managed<Gtk::Label>(text);
    label->set_xalign(0.0F);
    label->set_size_request(82, -1);
    auto* scale = Gtk::make_managed<Gtk::Scale>(Gtk::Orientation::HORIZONTAL);
    scale->set_range(low, high);
    scale->set_increments(step, 10.0 * step);
    scale->set_digits(2);
    scale->set_draw_value(true);
    scale->set_value_pos(Gtk::PositionType::RIGHT);
    scale->set_hexpand(true);
    scale->set_tooltip_text(hint);
    scale->signal_value_changed().connect([this, scale, action = std::move(action)] { act([&] { action(scale->get_value()); }); });
    row->append(*label);
    row->append(*scale);
    column_.append(*row);
    controls_.emplace_back(text, scale);
    return *scale;
}

Gtk::CheckButton& Panel::add_check(int column, int row, const char* text, std::function<void(bool)> action)
{
    auto* check = Gtk::make_managed<Gtk::CheckButton>(text);
    check->signal_toggled().connect([this, check, action = std::move(action)] { act([&] { action(check->get_active()); }); });
    checks_->attach(*check, column, row);
    controls_.emplace_back(text, check);
    return *check;
}

void Panel::add_scene_part(const std::vector<std::string>& scenes)
{
    add_heading("Scene");
    std::vector<Glib::ustring> names;
    for (const std::string& path : scenes) names.emplace_back(std::filesystem::path(path).stem().string());
    scenes_ = scenes;
    for (const GeneratorKind& kind : generator_kinds()) names.emplace_back("new: " + kind.name);
    scene_names_ = Gtk::StringList::create(names);
    scene_ = Gtk::make_managed<Gtk::DropDown>(scene_names_);
    scene_->set_tooltip_text("Scenes to open, and kinds to be generated anew");
    scene_->property_selected().signal_changed().connect([this] {
        const guint index = scene_->get_selected();
        const guint first = has_own_entry_ ? 1 : 0;
        if (index == GTK_INVALID_LIST_POSITION || index < first) return;
        act([&] { chosen_(static_cast<int>(index - first)); });
    });
    controls_.emplace_back("scene", scene_);
    column_.append(*scene_);
    Gtk::Box& row = add_row();
    add_button(row, "Open\u2026", "A scene file (Ctrl+O); or drop one on the window", [this] { press(stage_, "ctrl+o"); });
    add_button(row, "Save\u2026", "The scene as it is now (Ctrl+S)", [this] { press(stage_, "ctrl+s"); });
}

void Panel::add_time_part()
{
    add_heading("Time");
    Gtk::Box& row = add_row();
    pause_ = Gtk::make_managed<Gtk::ToggleButton>("Pause");
    pause_->set_tooltip_text("P or space");
    pause_->signal_toggled().connect([this] { act([this] { stage_.clock.is_paused = pause_->get_active(); }); });
    row.append(*pause_);
    controls_.emplace_back("Pause", pause_);
    add_button(row, "\u25c0", "One frame back (comma)", [this] { press(stage_, "comma"); });
    add_button(row, "\u25b6", "One frame on (full stop)", [this] { press(stage_, "period"); });
    add_button(row, "Reset", "To the beginning (Home)", [this] { press(stage_, "home"); });
    speed_ = &add_scale("Speed", -8.0, 6.0, 0.25, "Simulated seconds a second (+ and -)",
                        [this](double power) { set_speed(stage_, std::exp2(power)); });
    speed_->set_format_value_func([](double power) { return Glib::ustring(speed_text(std::exp2(power))); });
}

void Panel::add_world_part()
{
    add_heading("World");
    field_ = make_choice({"no field", "uniform gravity", "central field"});
    field_->set_tooltip_text("Shift+G; G and the arrows change its strength");
    field_->property_selected().signal_changed().connect([this] {
        act([this] {
            set_field_kind(stage_, static_cast<FieldKind>(field_->get_selected()));
            stage_.arrow_keys = ArrowKeys::gravity;
            stage_.mode_until = stage_.now + 3.0;
        });
    });
    column_.append(*field_);
    restitution_ = &add_scale("Restitution", 0.0, 1.0, 0.01, "R and the arrows; bodies with one of their own keep it",
                              [this](double e) { set_restitution(stage_, e); });
    friction_ = &add_scale("Friction", 0.0, 2.0, 0.01, "Bodies with one of their own keep it",
                           [this](double mu) { set_friction(stage_, mu); });
    follows_ = Gtk::make_managed<Gtk::CheckButton>("the box follows the window's size");
    follows_->signal_toggled().connect([this] { act([this] { stage_.box_follows = follows_->get_active(); }); });
    column_.append(*follows_);
    controls_.emplace_back("follows", follows_);
    controls_.emplace_back("field", field_);
}

void Panel::add_tool_part()
{
    add_heading("Hand");
    auto* grid = Gtk::make_managed<Gtk::Grid>();
    grid->set_column_homogeneous(true);
    grid->set_column_spacing(5);
    grid->set_row_spacing(5);
    const char* names[] = {"Grab", "Disc", "Polygon", "Draw", "Remove"};
    for (int k = 0; k < k_tools; ++k) {
        auto* button = Gtk::make_managed<Gtk::ToggleButton>(names[k]);
        button->set_tooltip_text(fmt::format("{} ({})", tool_text(static_cast<Tool>(k)), k + 1));
        if (k > 0) button->set_group(*tools_[0]);
        tools_[static_cast<std::size_t>(k)] = button;
        button->signal_toggled().connect([this, k, button] {
            if (button->get_active()) act([this, k] { take_tool(stage_, static_cast<Tool>(k)); });
        });
        controls_.emplace_back(names[k], button);
        grid->attach(*button, k % 3, k / 3);
    }
    undo_ = Gtk::make_managed<Gtk::Button>("Undo");
    undo_->set_tooltip_text("Ctrl+Z");
    undo_->signal_clicked().connect([this] { act([this] { press(stage_, "ctrl+z"); }); });
    controls_.emplace_back("Undo", undo_);
    grid->attach(*undo_, 0, 2);
    redo_ = Gtk::make_managed<Gtk::Button>("Redo");
    redo_->set_tooltip_text("Ctrl+Shift+Z, Ctrl+Y");
    redo_->signal_clicked().connect([this] { act([this] { press(stage_, "ctrl+y"); }); });
    controls_.emplace_back("Redo", redo_);
    grid->attach(*redo_, 1, 2);
    column_.append(*grid);
}

void Panel::add_look_part()
{
    add_heading("Shown");
    colouring_ = make_choice({"colours by number", "random colours", "colours by what moves bodies"});
    colouring_->property_selected().signal_changed().connect(
        [this] { act([this] { stage_.look.colouring = static_cast<Colouring>(colouring_->get_selected()); }); });
    controls_.emplace_back("colours", colouring_);
    column_.append(*colouring_);
    checks_ = Gtk::make_managed<Gtk::Grid>();
    checks_->set_column_homogeneous(false);
    checks_->set_column_spacing(8);
    for (int k = 0; k < static_cast<int>(k_layers); ++k) {
        const auto layer = static_cast<Layer>(k);
        layers_[static_cast<std::size_t>(k)] = &add_check(k % 2, k / 2, std::string(layer_text(layer)).c_str(), [this, layer](bool on) {
            if (stage_.look.shows(layer) != on) stage_.look.toggle(layer);
        });
    }
    const int row = static_cast<int>(k_layers + 1) / 2;
    dark_ = &add_check(0, row, "dark", [this](bool on) { stage_.look.is_dark = on; });
    turn_ = &add_check(1, row, "faces turn", [this](bool on) { stage_.look.faces_turn = on; });
    column_.append(*checks_);
}

void Panel::add_record_part()
{
    add_heading("Record");
    Gtk::Box& row = add_row();
    video_ = &add_button(row, "Video", "Record what is seen, or end it (F6)", [this] { press(stage_, "f6"); });
    trace_ = &add_button(row, "Trace", "Record the motion, or end it (F7)", [this] { press(stage_, "f7"); });
    add_button(row, "Face\u2026", "A picture for the balls (Ctrl+F); or drop a PNG on the window", [this] { press(stage_, "ctrl+f"); });
}

std::string Panel::places(Gtk::Widget& within) const
{
    std::string out = "{";
    for (const auto& [text, widget] : controls_) {
        double x = 0.0;
        double y = 0.0;
        const bool is_known = widget->get_mapped() &&
                              widget->translate_coordinates(within, 0.5 * widget->get_width(), 0.5 * widget->get_height(), x, y);
        if (is_known) out += fmt::format("{}{}:[{},{}]", out.size() > 1 ? "," : "", json_text(text), x, y);
    }
    return out + "}";
}

void Panel::show_scene(const std::string& scene, const std::string& words)
{
    is_syncing_ = true;
    const auto place = std::find(scenes_.begin(), scenes_.end(), scene);
    const bool is_listed = place != scenes_.end();
    scene_names_->splice(0, has_own_entry_ ? 1 : 0, is_listed ? std::vector<Glib::ustring>{} : std::vector<Glib::ustring>{words});
    has_own_entry_ = !is_listed;
    scene_->set_selected(is_listed ? static_cast<guint>(place - scenes_.begin()) : 0);
    is_syncing_ = false;
}

void Panel::sync(bool is_filming, bool is_tracing)
{
    is_syncing_ = true;
    const WorldDef& world = stage_.run.scene().world;
    pause_->set_active(stage_.clock.is_paused);
    speed_->set_value(std::log2(stage_.clock.speed));
    field_->set_selected(static_cast<guint>(field_kind(world.field)));
    restitution_->set_value(world.restitution);
    friction_->set_value(world.friction);
    follows_->set_active(stage_.box_follows);
    tools_[static_cast<std::size_t>(stage_.hand.tool)]->set_active(true);
    for (std::size_t k = 0; k < k_layers; ++k) layers_[k]->set_active(stage_.look.layers[k]);
    dark_->set_active(stage_.look.is_dark);
    turn_->set_active(stage_.look.faces_turn);
    colouring_->set_selected(static_cast<guint>(stage_.look.colouring));
    undo_->set_sensitive(stage_.run.can_undo());
    redo_->set_sensitive(stage_.run.can_redo());
    video_->set_label(is_filming ? "End video" : "Video");
    trace_->set_label(is_tracing ? "End trace" : "Trace");
    is_syncing_ = false;
}

} // namespace flying
