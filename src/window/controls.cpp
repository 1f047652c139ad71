#include "window/controls.hpp"

#include <fmt/format.h>
#include <gtkmm/label.h>

#include "play/state.hpp"

namespace flying {

Controls::Controls(std::function<void()> touched)
    : Gtk::Box(Gtk::Orientation::VERTICAL, 5), touched_(std::move(touched))
{
    set_margin(10);
}

void Controls::add_heading(const char* text)
{
    auto* label = Gtk::make_managed<Gtk::Label>();
    label->set_markup(fmt::format("<b>{}</b>", text));
    label->set_xalign(0.0F);
    label->set_margin_top(2);
    append(*label);
}

Gtk::Box& Controls::add_row()
{
    auto* row = Gtk::make_managed<Gtk::Box>(Gtk::Orientation::HORIZONTAL, 5);
    row->set_homogeneous(true);
    append(*row);
    return *row;
}

Gtk::Scale& Controls::add_scale(const char* text, double low, double high, double step, const char* hint,
                                std::function<void(double)> action)
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
    scale->signal_value_changed().connect(
        [this, scale, action = std::move(action)] { act([&] { action(scale->get_value()); }); });
    row->append(*label);
    row->append(*scale);
    append(*row);
    by_name_.emplace_back(text, scale);
    return *scale;
}

Gtk::Button& Controls::make_button(const char* text, const char* hint, std::function<void()> action)
{
    auto* button = Gtk::make_managed<Gtk::Button>(text);
    button->set_tooltip_text(hint);
    button->signal_clicked().connect([this, action = std::move(action)] { act(action); });
    by_name_.emplace_back(text, button);
    return *button;
}

Gtk::ToggleButton& Controls::make_toggle(const char* text, const std::string& hint, std::function<void()> on,
                                         std::function<void()> off)
{
    auto* button = Gtk::make_managed<Gtk::ToggleButton>(text);
    button->set_tooltip_text(hint);
    button->signal_toggled().connect([this, button, on = std::move(on), off = std::move(off)] {
        if (const auto& action = button->get_active() ? on : off) act(action);
    });
    by_name_.emplace_back(text, button);
    return *button;
}

Gtk::CheckButton& Controls::make_check(const std::string& text, const std::string& name,
                                       std::function<void(bool)> action)
{
    auto* check = Gtk::make_managed<Gtk::CheckButton>(text);
    check->signal_toggled().connect(
        [this, check, action = std::move(action)] { act([&] { action(check->get_active()); }); });
    by_name_.emplace_back(name, check);
    return *check;
}

Gtk::DropDown& Controls::make_list(const char* name, const Glib::RefPtr<Gtk::StringList>& entries,
                                   std::function<void(unsigned)> action)
{
    auto* list = Gtk::make_managed<Gtk::DropDown>(entries);
    list->property_selected().signal_changed().connect(
        [this, list, action = std::move(action)] { act([&] { action(list->get_selected()); }); });
    by_name_.emplace_back(name, list);
    return *list;
}

void Controls::act(const std::function<void()>& action)
{
    if (is_quiet_) return;
    action();
    touched_();
}

void Controls::quietly(const std::function<void()>& sync)
{
    is_quiet_ = true;
    sync();
    is_quiet_ = false;
}

std::string Controls::places(Gtk::Widget& within) const
{
    std::string out = "{";
    for (const auto& [name, widget] : by_name_) {
        double x = 0.0;
        double y = 0.0;
        const bool is_known = widget->get_mapped() && widget->translate_coordinates(within, 0.5 * widget->get_width(),
                                                                                    0.5 * widget->get_height(), x, y);
        if (is_known) out += fmt::format("{}{}:[{},{}]", out.size() > 1 ? "," : "", json_text(name), x, y);
    }
    return out + "}";
}

} // namespace flying
