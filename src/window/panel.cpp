#include "window/panel.hpp"

#include <gdk/gdk.h>
#include <gdkmm/frameclock.h>
#include <gtkmm/adjustment.h>
#include <gtkmm/eventcontrollerkey.h>
#include <gtkmm/native.h>
#include <gtkmm/root.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace flying {

namespace {

constexpr int k_width = 292; ///< [pixels]

} // namespace

Panel::Panel(Stage& stage, const std::vector<std::string>& scenes, std::function<void()> touched,
             std::function<void(int)> chosen)
    : stage_(stage),
      controls_(std::move(touched)),
      scene_(controls_, stage, scenes, std::move(chosen)),
      time_(controls_, stage),
      world_(controls_, stage),
      hand_(controls_, stage),
      look_(controls_, stage),
      record_(controls_, stage)
{
    set_policy(Gtk::PolicyType::NEVER, Gtk::PolicyType::AUTOMATIC);
    set_size_request(k_width, -1);
    set_hexpand(false); // its scales would like to
    set_child(controls_);
    auto keys = Gtk::EventControllerKey::create();
    keys->set_propagation_phase(Gtk::PropagationPhase::CAPTURE);
    keys->signal_key_pressed().connect([this](guint value, guint, Gdk::ModifierType) { return key(value); }, false);
    add_controller(keys);
}

Gtk::Widget* Panel::focus()
{
    Gtk::Root* root = get_root();
    Gtk::Widget* control = root ? root->get_focus() : nullptr;
    const bool is_ours = control && control->is_ancestor(controls_) && control->get_native() == get_native();
    return is_ours ? control : nullptr;
}

bool Panel::is_in_sight(Gtk::Widget& control)
{
    // By the scrollbar's value: the panel itself is drawn where it was scrolled to only with the next frame
    double x = 0.0;
    double y = 0.0;
    if (!control.translate_coordinates(controls_, 0.0, 0.5 * control.get_height(), x, y)) return false;
    y -= get_vadjustment()->get_value();
    return y >= 0.0 && y < get_height();
}

bool Panel::key(unsigned value)
{
    const unsigned working[] = {GDK_KEY_space, GDK_KEY_KP_Space, GDK_KEY_Return, GDK_KEY_ISO_Enter, GDK_KEY_KP_Enter};
    Gtk::Widget* control = focus();
    if (!control || is_in_sight(*control) ||
        std::find(std::begin(working), std::end(working), value) == std::end(working))
        return false;

    // Scroll to it first: GTK 4.8 gives a list that drops down beyond the screen's edge a place and a size that it
    // never set. Asked for at each frame: a wheel that turned just before goes on for some frames, and would take the
    // panel back
    add_tick_callback([this, control](const Glib::RefPtr<Gdk::FrameClock>&) {
        if (focus() != control) return false;
        if (is_in_sight(*control)) {
            control->activate();
            return false;
        }
        double x = 0.0;
        double y = 0.0;
        if (!control->translate_coordinates(controls_, 0.0, 0.0, x, y)) return false;
        get_vadjustment()->clamp_page(y, y + control->get_height() + 2.0 * controls_.get_margin_top());
        return true;
    });
    return true;
}

void Panel::show_scene(const std::string& scene, const std::string& words)
{
    controls_.quietly([&] { scene_.show(scene, words); });
}

void Panel::sync(bool is_filming, bool is_tracing)
{
    controls_.quietly([&] {
        time_.sync(stage_);
        world_.sync(stage_);
        hand_.sync(stage_);
        look_.sync(stage_);
        record_.sync(is_filming, is_tracing);
    });
}

} // namespace flying
