#include "json/saved_run.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "math/hash.hpp"
#include "scene/write.hpp"
#include "world/memory.hpp"
#include "json/hexadecimal.hpp"

namespace flying {

namespace {

using Json = nlohmann::json;

constexpr const char* k_format = "flying: a run to go on with";
constexpr int k_version = 1;

/// Sixteen digits for all bytes of a text.
std::string fingerprint(const std::string& text)
{
    Hash hash;
    for (const char c : text) hash.add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
    return hexadecimal(hash.value());
}

// ---- Numbers and what is made of them -------------------------------------------------------------------------------

/// The fewest digits that read back to the same bits; JSON has no words for what is not finite.
Json number(double x)
{
    if (std::isfinite(x)) return x;
    return std::isnan(x) ? "nan" : x > 0.0 ? "inf" : "-inf";
}

double number(const Json& json)
{
    if (!json.is_string()) return json.get<double>();
    const std::string& word = json.get_ref<const std::string&>();
    if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
    return word == "inf" ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
}

Json state_json(const BodyState& s)
{
    return {number(s.position.x()), number(s.position.y()), number(s.velocity.x()), number(s.velocity.y()),
            number(s.angle),        number(s.spin),         number(s.time)};
}

BodyState state_of(const Json& json)
{
    return {{number(json.at(0)), number(json.at(1))},
            {number(json.at(2)), number(json.at(3))},
            number(json.at(4)),
            number(json.at(5)),
            number(json.at(6))};
}

/// A list, one entry for each thing.
template <typename Things, typename Write>
Json list(const Things& things, const Write& write)
{
    Json json = Json::array();
    for (const auto& thing : things) json.push_back(write(thing));
    return json;
}

template <typename Thing, typename Read>
std::vector<Thing> list_of(const Json& json, const Read& read)
{
    std::vector<Thing> things;
    for (const Json& entry : json) things.push_back(read(entry));
    return things;
}

template <typename Enum>
Json code(Enum value)
{
    return static_cast<int>(value);
}

// ---- What the integrators remember ----------------------------------------------------------------------------------

Json flying_json(const EventEngine::Resume& m)
{
    return {{"time", number(m.time)},
            {"log_hash", m.log_hash},
            {"max_overlap", number(m.max_overlap)},
            {"energy_lost", number(m.energy_lost)},
            {"crowding", m.crowding},
            {"presence", list(m.presence, [](auto p) { return code(p); })},
            {"bounces", list(m.bounces, [](const EventEngine::Bounces& b) {
                 return Json{b.on, number(b.normal.x()), number(b.normal.y()), number(b.end)};
             })}};
}

EventEngine::Resume flying_of(const Json& json)
{
    EventEngine::Resume m;
    m.time = number(json.at("time"));
    m.log_hash = json.at("log_hash").get<std::uint64_t>();
    m.max_overlap = number(json.at("max_overlap"));
    m.energy_lost = number(json.at("energy_lost"));
    m.crowding = json.at("crowding").get<std::vector<int>>();
    m.presence = list_of<EventEngine::Presence>(
        json.at("presence"), [](const Json& p) { return static_cast<EventEngine::Presence>(p.get<int>()); });
    m.bounces = list_of<EventEngine::Bounces>(json.at("bounces"), [](const Json& b) {
        return EventEngine::Bounces{b.at(0).get<int>(), {number(b.at(1)), number(b.at(2))}, number(b.at(3))};
    });
    return m;
}

Json pair_json(const RestPair& pair)
{
    Json json{pair.a, pair.b, pair.part_a, pair.part_b, number(pair.friction), number(pair.restitution)};
    for (int k = 0; k < pair.count; ++k) {
        json.push_back({pair.feature[k], number(pair.place[k].x()), number(pair.place[k].y()), number(pair.normal[k]),
                        number(pair.tangent[k])});
    }
    return json;
}

RestPair pair_of(const Json& json)
{
    constexpr std::size_t k_points = 6; // entries before them
    RestPair pair;
    pair.a = json.at(0).get<int>();
    pair.b = json.at(1).get<int>();
    pair.part_a = json.at(2).get<int>();
    pair.part_b = json.at(3).get<int>();
    pair.friction = number(json.at(4));
    pair.restitution = number(json.at(5));
    pair.count = static_cast<int>(std::min<std::size_t>(json.size() - k_points, 2));
    for (int k = 0; k < pair.count; ++k) {
        const Json& point = json.at(k_points + static_cast<std::size_t>(k));
        pair.feature[k] = point.at(0).get<std::uint32_t>();
        pair.place[k] = {number(point.at(1)), number(point.at(2))};
        pair.normal[k] = number(point.at(3));
        pair.tangent[k] = number(point.at(4));
    }
    return pair;
}

Json resting_json(const RestEngine::Memory& m)
{
    // Only pairs that touch have anything to remember
    Json pairs = Json::array();
    for (const RestPair& pair : m.pairs) {
        if (pair.count > 0) pairs.push_back(pair_json(pair));
    }
    return {{"time", number(m.time)},
            {"max_overlap", number(m.max_overlap)},
            {"order", m.order},
            {"bodies", list(m.bodies,
                            [](const RestEngine::Memory::Body& b) {
                                return Json{state_json(b.state), number(b.pull.x()),
                                            number(b.pull.y()),  number(b.expected_angular_acceleration),
                                            number(b.reach),     b.sleep_island,
                                            b.is_active,         b.in_large_island};
                            })},
            {"pairs", std::move(pairs)}};
}

RestEngine::Memory resting_of(const Json& json)
{
    RestEngine::Memory m;
    m.time = number(json.at("time"));
    m.max_overlap = number(json.at("max_overlap"));
    m.order = json.at("order").get<std::vector<int>>();
    m.bodies = list_of<RestEngine::Memory::Body>(json.at("bodies"), [](const Json& b) {
        return RestEngine::Memory::Body{state_of(b.at(0)),  {number(b.at(1)), number(b.at(2))},
                                        number(b.at(3)),    number(b.at(4)),
                                        b.at(5).get<int>(), b.at(6).get<bool>(),
                                        b.at(7).get<bool>()};
    });
    m.pairs = list_of<RestPair>(json.at("pairs"), pair_of);
    return m;
}

Json hybrid_json(const Hybrid::Memory& m)
{
    return {{"flying", flying_json(m.flying)},
            {"resting", m.resting ? resting_json(*m.resting) : Json()},
            {"movers", list(m.movers, [](BodyMover mover) { return code(mover); })},
            {"clear", list(m.clear, [](char count) { return Json(static_cast<int>(count)); })},
            {"step_ends", number(m.step_ends)},
            {"energy_of_steps", number(m.energy_of_steps)},
            {"energy_of_blows", number(m.energy_of_blows)}};
}

Hybrid::Memory hybrid_of(const Json& json)
{
    Hybrid::Memory m;
    m.flying = flying_of(json.at("flying"));
    if (!json.at("resting").is_null()) m.resting = resting_of(json.at("resting"));
    m.movers = list_of<BodyMover>(json.at("movers"),
                                  [](const Json& mover) { return static_cast<BodyMover>(mover.get<int>()); });
    m.clear = list_of<char>(json.at("clear"), [](const Json& count) { return static_cast<char>(count.get<int>()); });
    m.step_ends = number(json.at("step_ends"));
    m.energy_of_steps = number(json.at("energy_of_steps"));
    m.energy_of_blows = number(json.at("energy_of_blows"));
    return m;
}

// ---- The whole ------------------------------------------------------------------------------------------------------

Json handover_json(const Handover& h)
{
    return {{"time", number(h.time)},
            {"bodies", h.bodies},
            {"reason", h.reason},
            {"to", code(h.to)},
            {"energy_change", number(h.energy_change)},
            {"energy_before", number(h.energy_before)},
            {"energy_after", number(h.energy_after)},
            {"ends_bounces", h.ends_bounces}};
}

Handover handover_of(const Json& json)
{
    return {number(json.at("time")),
            json.at("bodies").get<std::vector<int>>(),
            json.at("reason"),
            number(json.at("energy_change")),
            static_cast<Handover::To>(json.at("to").get<int>()),
            number(json.at("energy_before")),
            number(json.at("energy_after")),
            json.at("ends_bounces").get<bool>()};
}

SavedRun saved_run_of(const Json& json)
{
    SavedRun run;
    const Json& options = json.at("options");
    run.options.engine = static_cast<EngineChoice>(options.at("engine").get<int>());
    run.options.step = number(options.at("step"));
    run.options.without = options.at("without").get<std::vector<std::string>>();
    Snapshot& s = run.snapshot;
    s.time = number(json.at("time"));
    s.bodies = list_of<BodyState>(json.at("bodies"), state_of);
    s.events = json.at("events").get<std::int64_t>();
    s.collisions = json.at("collisions").get<std::int64_t>();
    s.max_overlap = number(json.at("max_overlap"));
    s.initial_total = number(json.at("initial_total"));
    const Json& ledger = json.at("ledger");
    s.ledger = {number(ledger.at(0)), number(ledger.at(1)), number(ledger.at(2))};
    s.handovers = list_of<Handover>(json.at("handovers"), handover_of);
    s.engines = std::make_shared<const EngineMemory>(EngineMemory{hybrid_of(json.at("engines"))});
    return run;
}

} // namespace

std::string write_saved_run(const Scene& scene, const WorldOptions& options, const Snapshot& s)
{
    Json json{
        {"format", k_format},
        {"version", k_version},
        {"scene", {{"title", scene.title}, {"fingerprint", fingerprint(write_scene(scene))}}},
        {"options", {{"engine", code(options.engine)}, {"step", number(options.step)}, {"without", options.without}}},
        {"time", number(s.time)},
        {"bodies", list(s.bodies, state_json)},
        {"events", s.events},
        {"collisions", s.collisions},
        {"max_overlap", number(s.max_overlap)},
        {"initial_total", number(s.initial_total)},
        {"ledger", {number(s.ledger.impacts), number(s.ledger.steps), number(s.ledger.handovers)}},
        {"handovers", list(s.handovers, handover_json)},
        {"engines", hybrid_json(s.engines->hybrid)}};
    const std::string content = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    json["fingerprint"] = fingerprint(content);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Expected<SavedRun> read_saved_run(const std::string& path, const Scene& scene)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf())) return Fault{path, "no file that can be read", "one that --save has written"};
    return read_saved_run_text(text.str(), path, scene);
}

Expected<SavedRun> read_saved_run_text(const std::string& text, const std::string& place, const Scene& scene)
{
    Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) return Fault{place, "a file that is cut short, or no JSON", "one that --save has written"};
    if (!json.is_object() || json.value("format", Json()) != k_format) {
        return Fault{place, "JSON of another kind", "a file that --save has written"};
    }
    if (json.value("version", Json()) != k_version) {
        return Fault{place, "version " + json.value("version", Json()).dump(), "version " + std::to_string(k_version)};
    }
    try {
        const std::string written = json.at("fingerprint");
        json.erase("fingerprint");
        const std::string found = fingerprint(json.dump(-1, ' ', false, Json::error_handler_t::replace));
        if (found != written) {
            return Fault{place, "content with the fingerprint " + found, written + ", with which it was written"};
        }

        // No other scene can be gone on with, not even one whose bodies have other names
        const std::string expected = fingerprint(write_scene(scene));
        const Json& own = json.at("scene");
        if (own.at("fingerprint") != expected) {
            const std::string title = own.at("title");
            const std::string found_scene = own.at("fingerprint");
            return Fault{place, "a run of the scene \"" + title + "\", fingerprint " + found_scene,
                         "one of \"" + scene.title + "\", fingerprint " + expected};
        }
        return saved_run_of(json);
    } catch (const Json::exception& error) {
        return Fault{place, error.what(), "a file that --save has written"};
    }
}

} // namespace flying
