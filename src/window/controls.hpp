#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtkmm/box.h>
#include <gtkmm/button.h>
#include <gtkmm/checkbutton.h>
#include <gtkmm/dropdown.h>
#include <gtkmm/scale.h>
#include <gtkmm/stringlist.h>
#include <gtkmm/togglebutton.h>

namespace flying {

/// A column of controls. It makes them, knows each by a name, the text of a button or a scale, and tells an action of
/// the user from a change that only brings a control up to what it shows.
class Controls : public Gtk::Box
{
public:
    /// touched  called after each action of the user
    explicit Controls(std::function<void()> touched);

    // Rows of the column
    void add_heading(const char* text);
    Gtk::Box& add_row();
    Gtk::Scale& add_scale(const char* text, double low, double high, double step, const char* hint,
                          std::function<void(double)> action);

    // Controls that have no place in the column yet
    [[nodiscard]] Gtk::Button& make_button(const char* text, const char* hint, std::function<void()> action);
    /// on   when it goes down
    /// off  when it comes up; empty where that is no action of its own, as in a group in which another goes down
    [[nodiscard]] Gtk::ToggleButton& make_toggle(const char* text, const std::string& hint, std::function<void()> on,
                                                 std::function<void()> off);
    /// name  by which it is known, as for a list
    [[nodiscard]] Gtk::CheckButton& make_check(const std::string& text, const std::string& name,
                                               std::function<void(bool)> action);
    [[nodiscard]] Gtk::DropDown& make_list(const char* name, const Glib::RefPtr<Gtk::StringList>& entries,
                                           std::function<void(unsigned)> action);

    /// Bring controls up to what they show: nothing that they do meanwhile is an action of the user.
    void quietly(const std::function<void()>& sync);

    /// Where the controls are, as JSON by their names: {"Pause": [x, y], ...}.
    /// within  the widget whose pixels these are
    [[nodiscard]] std::string places(Gtk::Widget& within) const;

private:
    /// Run an action of the user; nothing while `quietly` runs.
    void act(const std::function<void()>& action);

    std::function<void()> touched_;
    bool is_quiet_ = false;
    std::vector<std::pair<std::string, Gtk::Widget*>> by_name_;
};

} // namespace flying
