#include "play/state.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "play/paint_stage.hpp"

namespace flying {

namespace {

std::string number(double value)
{
    return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null";
}

std::string point(const Vec2& at)
{
    return fmt::format("[{},{}]", number(at.x()), number(at.y()));
}

const char* truth(bool value)
{
    return value ? "true" : "false";
}

std::string field_json(const Field& field)
{
    if (const auto* central = std::get_if<CentralField>(&field)) {
        return fmt::format("{{\"kind\":\"central\",\"mu\":{},\"radius\":{},\"centre\":{}}}", number(central->mu), number(central->radius), point(central->centre));
    }
    if (const auto* uniform = std::get_if<UniformField>(&field)) {
        return fmt::format("{{\"kind\":\"uniform\",\"gravity\":{}}}", point(uniform->gravity));
    }
    return "{\"kind\":\"none\"}";
}

std::string bodies_json(const World& world)
{
    constexpr const char* movers[] = {"none", "events", "rest", "asleep"};
    std::string out = "[";
    for (int k = 0; k < world.body_count(); ++k) {
        const BodyState s = world.state(k);
        fmt::format_to(std::back_inserter(out),
                       "{}\n  {{\"name\":{},\"static\":{},\"mover\":\"{}\",\"x\":{},\"y\":{},\"angle\":{},\"vx\":{},\"vy\":{},\"spin\":{}}}",
                       k == 0 ? "" : ",", json_text(world.scene().bodies[static_cast<std::size_t>(k)].name), truth(world.is_static(k)),
                       movers[static_cast<int>(world.mover(k))], number(s.position.x()), number(s.position.y()), number(s.angle),
                       number(s.velocity.x()), number(s.velocity.y()), number(s.spin));
    }
    return out + "]";
}

std::string layers_json(const Look& look)
{
    std::string out = "[";
    for (std::size_t k = 0; k < k_layers; ++k) {
        if (!look.layers[k]) continue;
        out += (out.size() > 1 ? "," : "") + json_text(layer_text(static_cast<Layer>(k)));
    }
    return out + "]";
}

} // namespace

std::string json_text(std::string_view text)
{
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < ' ') out += fmt::format("\\u{:04x}", static_cast<int>(c));
        else out += c;
    }
    return out + '"';
}

std::string state_json(const Stage& stage, const std::string& more)
{
    constexpr const char* arrow_keys[] = {"pointer", "restitution", "gravity"};
    constexpr const char* colourings[] = {"number", "random", "mover"};
    const WorldDef& world = stage.run.scene().world;
    const Hand& hand = stage.hand;
    std::string out = "{";
    const auto add = [&](const char* key, const std::string& value) { out += fmt::format("{}\"{}\":{}", out.size() > 1 ? ",\n" : "", key, value); };
    add("time", number(stage.run.time()));
    add("generation", std::to_string(stage.run.generation()));
    add("paused", truth(stage.clock.is_paused));
    add("speed", number(stage.clock.speed));
    add("share", number(stage.clock.share));
    add("behind", truth(stage.clock.is_behind()));
    add("events", std::to_string(stage.run.events()));
    add("collisions", std::to_string(stage.run.collisions()));
    add("restitution", number(world.restitution));
    add("friction", number(world.friction));
    add("field", field_json(world.field));
    add("box", world.box ? fmt::format("[{},{}]", point(world.box->min), point(world.box->max)) : "null");
    add("tool", json_text(tool_text(hand.tool)));
    add("arrow_keys", json_text(arrow_keys[static_cast<int>(stage.arrow_keys)]));
    add("selected", std::to_string(hand.selected));
    add("holds", std::to_string(hand.grip ? hand.grip->body : -1));
    add("pointer", point(hand.pointer));
    add("points", std::to_string(hand.points.size()));
    add("sides", std::to_string(hand.sides));
    add("size", number(hand.size));
    add("layers", layers_json(stage.look));
    add("colouring", json_text(colourings[static_cast<int>(stage.look.colouring)]));
    add("dark", truth(stage.look.is_dark));
    add("faces_turn", truth(stage.look.faces_turn));
    add("box_follows", truth(stage.box_follows));
    add("face", truth(stage.face != nullptr));
    add("ship", fmt::format("{{\"body\":{},\"heading\":{},\"thrust\":{},\"burns\":{}}}", stage.ship.body, number(stage.ship.heading),
                            number(stage.ship.thrust), truth(stage.ship.burns(stage.now))));
    add("view", fmt::format("[{},{}]", point(stage.picture.view.min), point(stage.picture.view.max)));
    add("surface", fmt::format("[{},{}]", stage.size.width, stage.size.height));
    const ViewMap map = stage_map(stage, stage.size);
    add("map", fmt::format("[{},{},{}]", number(map.scale), number(map.origin.x()), number(map.origin.y())));
    const auto spread = [&](const FrameCosts& costs) {
        return fmt::format("{{\"median\":{},\"p95\":{}}}", number(costs.quantile(0.5)), number(costs.quantile(0.95)));
    };
    add("costs", fmt::format("{{\"simulating\":{},\"drawing\":{},\"interval\":{}}}", spread(stage.watch.simulating),
                             spread(stage.watch.drawing), spread(stage.watch.intervals)));
    add("notice", json_text(stage.notice.text));
    add("can_undo", truth(stage.run.can_undo()));
    add("can_redo", truth(stage.run.can_redo()));
    add("bodies", bodies_json(stage.run.world()));
    if (!more.empty()) out += ",\n" + more;
    return out + "}\n";
}

std::string trace_line(const Stage& stage)
{
    const World& world = stage.run.world();
    std::string line = fmt::format("{{\"time\":{},\"events\":{},\"bodies\":[", number(stage.run.time()), stage.run.events());
    for (int k = 0; k < world.body_count(); ++k) {
        const BodyState s = world.state(k);
        fmt::format_to(std::back_inserter(line), "{}[{},{},{},{},{},{}]", k == 0 ? "" : ",", number(s.position.x()), number(s.position.y()),
                       number(s.angle), number(s.velocity.x()), number(s.velocity.y()), number(s.spin));
    }
    return line + "]}\n";
}

} // namespace flying
