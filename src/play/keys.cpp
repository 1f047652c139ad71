#include "play/keys.hpp"

#include <algorithm>
#include <array>

namespace flying {

namespace {

void use_arrows_for(Stage& stage, ArrowKeys what)
{
    // The same key again puts the bar away
    const bool is_shown = stage.arrow_keys == what && stage.now < stage.mode_until;
    stage.arrow_keys = is_shown ? ArrowKeys::pointer : what;
    stage.mode_until = is_shown ? 0.0 : stage.now + 3.0;
}

/// The crosshair goes a fortieth of the height in sight, or a two-hundredth.
void move_pointer(Stage& stage, int x, int y, bool coarse)
{
    const Aabb& view = stage.picture.view;
    const Vec2 extent = view.max - view.min;
    const double way = extent.maxCoeff() / (coarse ? 25.0 : 160.0);
    if (!stage.hand.is_here) stage.hand.pointer = 0.5 * (view.min + view.max);
    const Vec2 place = stage.hand.pointer + way * Vec2(x, y);
    point_by_keys(stage, place.cwiseMax(view.min).cwiseMin(view.max));
}

template <int X, int Y, bool Coarse>
void arrow(Stage& stage)
{
    if (stage.arrow_keys != ArrowKeys::pointer) turn_knob(stage, X, Y, Coarse);
    else move_pointer(stage, X, Y, Coarse);
}

template <Tool T>
void take(Stage& stage)
{
    take_tool(stage, T);
}

void more_sides(Stage& stage, int more)
{
    stage.hand.sides = std::clamp(stage.hand.sides + more, 3, 12);
}

void escape(Stage& stage)
{
    const bool was_busy = stage.hand.grip || stage.hand.is_pressed || !stage.hand.points.empty();
    if (!stage.hand.points.empty()) stage.notice = {}; // what was wrong with the drawing goes with it
    cancel(stage);
    stage.arrow_keys = ArrowKeys::pointer;
    stage.mode_until = 0.0;
    if (stage.look.shows(Layer::help)) stage.look.toggle(Layer::help);
    else if (!was_busy) take_tool(stage, Tool::grab);
}

void colour_by(Stage& stage, Colouring colouring)
{
    stage.look.colouring = stage.look.colouring == colouring ? Colouring::number : colouring;
}

void zoom_by(Stage& stage, double factor)
{
    zoom(stage, factor, Vec2(0.5 * stage.size.width, 0.5 * stage.size.height));
}

template <Request R>
void ask(Stage& stage)
{
    stage.requests.push_back(R);
}

template <Layer L>
void toggle(Stage& stage)
{
    stage.look.toggle(L);
}

void next_field(Stage& stage)
{
    const FieldKind kind = field_kind(stage.run.scene().world.field);
    set_field_kind(stage, kind == FieldKind::none      ? FieldKind::uniform
                          : kind == FieldKind::uniform ? FieldKind::central
                                                       : FieldKind::none);
    stage.arrow_keys = ArrowKeys::gravity;
    stage.mode_until = stage.now + 3.0;
}

void undo(Stage& stage)
{
    const std::string label = stage.run.undo();
    stage.refresh();
    stage.say(label.empty() ? "Nothing to undo" : "Undone: " + label);
}

void redo(Stage& stage)
{
    const std::string label = stage.run.redo();
    stage.refresh();
    stage.say(label.empty() ? "Nothing to redo" : "Redone: " + label);
}

constexpr auto k_bindings = std::to_array<Binding>({
    {"p space", "P, space", "pause, go on", [](Stage& s) { s.clock.is_paused = !s.clock.is_paused; }},
    {"period", ".", "one frame on", [](Stage& s) { step(s, 1); }},
    {"comma", ",", "one frame back", [](Stage& s) { step(s, -1); }},
    {"shift+greater greater", ">", "twenty frames on", [](Stage& s) { step(s, 20); }},
    {"shift+less less", "<", "twenty frames back", [](Stage& s) { step(s, -20); }},
    {"plus shift+plus equal kp_add", "+", "time runs faster", [](Stage& s) { set_speed(s, 2.0 * s.clock.speed); }},
    {"minus kp_subtract", "-", "time runs slower", [](Stage& s) { set_speed(s, 0.5 * s.clock.speed); }},
    {"ctrl+z", "Ctrl+Z", "undo", undo},
    {"ctrl+shift+z ctrl+y", "Ctrl+Y", "redo; also Ctrl+Shift+Z", redo},
    {"home f5", "Home, F5", "reset",
     [](Stage& s) {
         s.run.reset();
         s.refresh();
     }},
    {"r", "R", "arrows change the restitution", [](Stage& s) { use_arrows_for(s, ArrowKeys::restitution); }},
    {"g", "G", "arrows change the gravity", [](Stage& s) { use_arrows_for(s, ArrowKeys::gravity); }},
    {"shift+g", "Shift+G", "no field, a uniform or a central one", next_field},
    {"left", "arrows", "what R or G has chosen; or the crosshair", arrow<-1, 0, false>},
    {"right", "", "", arrow<1, 0, false>},
    {"up", "", "", arrow<0, 1, false>},
    {"down", "", "", arrow<0, -1, false>},
    {"shift+left", "Shift+arrows", "the same, ten times as much", arrow<-1, 0, true>},
    {"shift+right", "", "", arrow<1, 0, true>},
    {"shift+up", "", "", arrow<0, 1, true>},
    {"shift+down", "", "", arrow<0, -1, true>},
    {"return kp_enter", "Return", "press or let go at the crosshair", press_return},
    {"1", "1", "tool: grab and throw", take<Tool::grab>},
    {"2", "2", "tool: add discs", take<Tool::disc>},
    {"3", "3", "tool: add regular polygons", take<Tool::polygon>},
    {"4", "4", "tool: draw polygons, point by point", take<Tool::draw>},
    {"5", "5", "tool: remove bodies", take<Tool::remove>},
    {"bracketright", "]", "larger new bodies", [](Stage& s) { resize_new(s, 1); }},
    {"bracketleft", "[", "smaller new bodies", [](Stage& s) { resize_new(s, -1); }},
    {"page_up prior", "Page up", "more sides of new polygons", [](Stage& s) { more_sides(s, 1); }},
    {"page_down next", "Page down", "fewer sides", [](Stage& s) { more_sides(s, -1); }},
    {"backspace", "Backspace", "take back the last point of a drawing", take_point_back},
    {"delete", "Delete", "remove the body that is chosen", [](Stage& s) { remove_body(s, s.hand.selected); }},
    {"b", "B", "choose the next body", [](Stage& s) { select_next(s, 1); }},
    {"shift+b", "Shift+B", "choose the one before", [](Stage& s) { select_next(s, -1); }},
    {"escape", "Escape", "let go; drop the drawing; grab again", escape},
    {"ctrl+plus ctrl+shift+plus ctrl+equal ctrl+kp_add", "Ctrl +", "zoom in; also Ctrl and scrolling",
     [](Stage& s) { zoom_by(s, 1.25); }},
    {"ctrl+minus ctrl+kp_subtract", "Ctrl -", "zoom out", [](Stage& s) { zoom_by(s, 0.8); }},
    {"z ctrl+0", "Z, Ctrl+0", "see all", fit_view},
    {"s", "S", "speed arrows", toggle<Layer::arrows>},
    {"c", "C", "contact points", toggle<Layer::contacts>},
    {"n", "N", "normals", toggle<Layer::normals>},
    {"i", "I", "impulses", toggle<Layer::impulses>},
    {"x", "X", "bounding boxes", toggle<Layer::boxes>},
    {"k", "K", "cells of the search for neighbours", toggle<Layer::cells>},
    {"o", "O", "islands of bodies that lean", toggle<Layer::islands>},
    {"e", "E", "events that come next", toggle<Layer::next>},
    {"t", "T", "trails", toggle<Layer::trails>},
    {"m", "M", "centres of mass, radii of gyration", toggle<Layer::centroids>},
    {"l", "L", "labels", toggle<Layer::labels>},
    {"h", "H", "strips of energy and momentum", toggle<Layer::strips>},
    {"w", "W", "what the plan skips", toggle<Layer::plan>},
    {"f", "F", "what a frame costs", toggle<Layer::costs>},
    {"a", "A", "colour by what moves a body", [](Stage& s) { colour_by(s, Colouring::mover); }},
    {"u", "U", "random colours", [](Stage& s) { colour_by(s, Colouring::random); }},
    {"y", "Y", "faces turn with their balls, or not", [](Stage& s) { s.look.faces_turn = !s.look.faces_turn; }},
    {"v", "V", "steer the body that is chosen, or none", [](Stage& s) { board(s, s.hand.selected); }},
    {"ctrl+left", "Ctrl+arrows", "steer the ship, as scrolling does", [](Stage& s) { steer(s, -1.0, 0.0); }},
    {"ctrl+right", "", "", [](Stage& s) { steer(s, 1.0, 0.0); }},
    {"ctrl+up", "", "", [](Stage& s) { steer(s, 0.0, 1.0); }},
    {"ctrl+down", "", "", [](Stage& s) { steer(s, 0.0, -1.0); }},
    {"d", "D", "dark or light", [](Stage& s) { s.look.is_dark = !s.look.is_dark; }},
    {"f1", "F1", "this help", toggle<Layer::help>},
    {"ctrl+o", "Ctrl+O", "open a scene; also drop a file", ask<Request::open>},
    {"ctrl+s", "Ctrl+S", "save the scene as it is now", ask<Request::save>},
    {"ctrl+f", "Ctrl+F", "a picture for the balls; also drop a PNG", ask<Request::face>},
    {"f6", "F6", "record a video, or end it", ask<Request::video>},
    {"f7", "F7", "record a trace, or end it", ask<Request::trace>},
    {"f8", "F8", "write down all that the window knows", ask<Request::state>},
    {"f9", "F9", "controls at the side, or none; Tab goes there", ask<Request::panel>},
    {"f11", "F11", "the whole screen", ask<Request::fullscreen>},
    {"j", "J", "the box follows the window's size, or not", [](Stage& s) { s.box_follows = !s.box_follows; }},
    {"q ctrl+q", "Q", "quit", ask<Request::quit>},
});

bool names(const Binding& binding, std::string_view key)
{
    std::string_view rest = binding.keys;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == key) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

} // namespace

std::span<const Binding> bindings()
{
    return k_bindings;
}

bool press(Stage& stage, std::string_view key)
{
    for (const Binding& binding : k_bindings) {
        if (!names(binding, key)) continue;
        binding.act(stage);
        stage.refresh();
        return true;
    }
    return false;
}

} // namespace flying
