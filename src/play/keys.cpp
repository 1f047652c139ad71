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

template <int X, int Y, bool Coarse>
void arrow(Stage& stage)
{
    if (stage.arrow_keys != ArrowKeys::pointer) turn_knob(stage, X, Y, Coarse);
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

constexpr auto k_bindings = std::to_array<Binding>({
    {"p space", "P, space", "pause, go on", [](Stage& s) { s.clock.is_paused = !s.clock.is_paused; }},
    {"period", ".", "one frame on", [](Stage& s) { step(s, 1); }},
    {"comma", ",", "one frame back", [](Stage& s) { step(s, -1); }},
    {"shift+greater greater", ">", "twenty frames on", [](Stage& s) { step(s, 20); }},
    {"shift+less less", "<", "twenty frames back", [](Stage& s) { step(s, -20); }},
    {"plus shift+plus equal kp_add", "+", "time runs faster", [](Stage& s) { set_speed(s, 2.0 * s.clock.speed); }},
    {"minus kp_subtract", "-", "time runs slower", [](Stage& s) { set_speed(s, 0.5 * s.clock.speed); }},
    {"ctrl+z", "Ctrl+Z", "undo", undo},
    {"home f5", "Home, F5", "reset",
     [](Stage& s) {
         s.run.reset();
         s.refresh();
     }},
    {"r", "R", "arrows change the restitution", [](Stage& s) { use_arrows_for(s, ArrowKeys::restitution); }},
    {"g", "G", "arrows change the gravity", [](Stage& s) { use_arrows_for(s, ArrowKeys::gravity); }},
    {"shift+g", "Shift+G", "no field, a uniform or a central one", next_field},
    {"left", "arrows", "change what R or G has chosen", arrow<-1, 0, false>},
    {"right", "", "", arrow<1, 0, false>},
    {"up", "", "", arrow<0, 1, false>},
    {"down", "", "", arrow<0, -1, false>},
    {"shift+left", "Shift+arrows", "the same, ten times as much", arrow<-1, 0, true>},
    {"shift+right", "", "", arrow<1, 0, true>},
    {"shift+up", "", "", arrow<0, 1, true>},
    {"shift+down", "", "", arrow<0, -1, true>},
    {"s", "S", "speed arrows", toggle<Layer::arrows>},
    {"d", "D", "dark or light", [](Stage& s) { s.look.is_dark = !s.look.is_dark; }},
    {"f1", "F1", "this help", toggle<Layer::help>},
    {"q ctrl+q", "Q", "quit", [](Stage& s) { s.wants_to_quit = true; }},
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
        return true;
    }
    return false;
}

} // namespace flying
