#include <gdk/gdk.h>
#include <gdkmm/event.h>
#include <giomm/file.h>
#include <gtkmm/droptarget.h>
#include <gtkmm/eventcontrollermotion.h>
#include <gtkmm/eventcontrollerscroll.h>
#include <gtkmm/gestureclick.h>
#include <gtkmm/gesturedrag.h>

#include <cmath>
#include <optional>
#include <utility>

#include "play/paint_stage.hpp"
#include "window/main_window.hpp"

namespace flying {

namespace {

constexpr double k_zoom = 1.15; ///< of one notch

/// The time of an event [s]; none where it has none, as when the pointer comes in since something has moved away over it.
/// milliseconds  as GTK has it; 0 for none
std::optional<double> event_time(guint32 milliseconds)
{
    if (milliseconds == 0) return std::nullopt;
    return 1e-3 * milliseconds;
}

bool is_control(Gdk::ModifierType modifiers)
{
    return (modifiers & Gdk::ModifierType::CONTROL_MASK) == Gdk::ModifierType::CONTROL_MASK;
}

} // namespace

void MainWindow::point(const Gtk::EventController& controller, const Vec2& pixel)
{
    // Of the moves within one frame GTK tells the last, which knows the others: where they were on the surface, and when
    const auto event = controller.get_current_event();
    Vec2 last = Vec2::Zero();
    if (event && event->get_event_type() == Gdk::Event::Type::MOTION_NOTIFY && event->get_position(last.x(), last.y())) {
        guint count = 0;
        GdkTimeCoord* earlier = gdk_event_get_history(const_cast<GdkEvent*>(event->gobj()), &count);
        for (guint k = 0; k < count; ++k) {
            const Vec2 place(earlier[k].axes[GDK_AXIS_X], earlier[k].axes[GDK_AXIS_Y]);
            point_at(stage_, pixel + place - last, event_time(earlier[k].time));
        }
        g_free(earlier);
    }
    point_at(stage_, pixel, event_time(controller.get_current_event_time()));
    is_stale_ = true;
}

void MainWindow::listen_to_pointer()
{
    auto motion = Gtk::EventControllerMotion::create();
    const auto move = [this, &controller = *motion.get()](double x, double y) { point(controller, Vec2(x, y)); };
    motion->signal_enter().connect(move);
    motion->signal_motion().connect(move);
    motion->signal_leave().connect([this] {
        leave(stage_);
        is_stale_ = true;
    });
    canvas_.add_controller(motion);

    for (const auto& [number, button] : {std::pair(1U, Button::left), std::pair(3U, Button::right)}) {
        auto click = Gtk::GestureClick::create();
        click->set_button(number);
        click->signal_pressed().connect([this, kind = button, &controller = *click.get()](int, double x, double y) {
            canvas_.grab_focus();
            point(controller, Vec2(x, y));
            press_button(stage_, kind);
            touch();
        });
        if (button == Button::left) {
            const auto release = [this] {
                release_button(stage_);
                touch();
            };
            click->signal_released().connect([this, release, &controller = *click.get()](int, double x, double y) {
                point(controller, Vec2(x, y));
                release();
            });
            // What is taken from the hand isn't thrown
            click->signal_cancel().connect([this, release](Gdk::EventSequence*) {
                stage_.hand.traces.clear();
                release();
            });
        }
        canvas_.add_controller(click);
    }

    // The middle button moves the view
    auto drag = Gtk::GestureDrag::create();
    drag->set_button(2);
    drag->signal_drag_begin().connect([this](double, double) { dragged_ = Vec2::Zero(); });
    drag->signal_drag_update().connect([this](double x, double y) {
        pan(stage_, Vec2(x, y) - dragged_);
        dragged_ = Vec2(x, y);
        is_stale_ = true;
    });
    canvas_.add_controller(drag);

    auto wheel = Gtk::EventControllerScroll::create();
    wheel->set_flags(Gtk::EventControllerScroll::Flags::BOTH_AXES);
    wheel->signal_scroll().connect(
        [this, &controller = *wheel.get()](double dx, double dy) { return scroll(dx, dy, controller.get_current_event_state()); }, true);
    canvas_.add_controller(wheel);
}

bool MainWindow::scroll(double dx, double dy, Gdk::ModifierType modifiers)
{
    if (is_control(modifiers)) {
        zoom(stage_, std::pow(k_zoom, -dy), stage_map(stage_, stage_.size)(stage_.hand.pointer));
    } else if (stage_.hand.tool == Tool::disc || stage_.hand.tool == Tool::polygon) {
        resize_new(stage_, dy < 0.0 ? 1 : -1);
    } else {
        steer(stage_, dx, -dy);
    }
    touch();
    return true;
}

void MainWindow::listen_to_drops()
{
    auto target = Gtk::DropTarget::create(G_TYPE_FILE, Gdk::DragAction::COPY);
    target->signal_drop().connect(
        [this](const Glib::ValueBase& value, double, double) {
            GObject* object = static_cast<GObject*>(g_value_get_object(value.gobj()));
            if (!object || !G_IS_FILE(object)) return false;
            char* path = g_file_get_path(G_FILE(object));
            if (!path) return false;
            open_path(path);
            g_free(path);
            return true;
        },
        true);
    add_controller(target);
}

} // namespace flying
