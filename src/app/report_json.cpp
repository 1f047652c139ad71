#include "app/report_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace flying {

namespace {

/// A string with its quotes; what is no UTF-8 becomes a question mark.
std::string json_text(const std::string& text)
{
    return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string json_vector(const Vec2& vector)
{
    return fmt::format("[{}, {}]", json_number(vector.x()), json_number(vector.y()));
}

const char* json_bool(bool value)
{
    return value ? "true" : "false";
}

const char* class_letter(SkipClass kind)
{
    switch (kind) {
    case SkipClass::neutral:
        return "N";
    case SkipClass::ordered:
        return "O";
    case SkipClass::altering:
        break;
    }
    return "A";
}

std::string plan_json(const Plan& plan)
{
    std::string skips;
    for (const Skip& skip : plan.skips) {
        skips += fmt::format("{}\n      {{\"name\": {}, \"class\": \"{}\", \"active\": {}, \"reason\": {}, \"saved\": "
                             "{}, \"unit\": {}}}",
                             skips.empty() ? "" : ",", json_text(skip.name), class_letter(skip.kind),
                             json_bool(skip.active), json_text(skip.reason), skip.saved, json_text(skip.saved_unit));
    }
    return fmt::format("{{\n    \"pair_finder\": \"{}\",\n    \"skips\": [{}{}]\n  }}",
                       plan.pair_finder == PairFinder::grid ? "grid" : "all pairs", skips,
                       skips.empty() ? "" : "\n    ");
}

std::string stages_json(const std::vector<StageCost>& stages)
{
    std::string text;
    for (const StageCost& stage : stages) {
        text += fmt::format("{}\n    {}: {{\"count\": {}, \"seconds\": {}}}", text.empty() ? "" : ",",
                            json_text(stage.name), stage.count, json_number(stage.seconds));
    }
    return text.empty() ? "{}" : "{" + text + "\n  }";
}

std::string body_json(const BodyReport& body)
{
    const bool is_static = body.mass == 0.0;
    return fmt::format("{{\"name\": {}, \"position\": {}, \"angle\": {}, \"velocity\": {}, \"spin\": {}, "
                       "\"mass\": {}, \"inertia\": {}}}",
                       json_text(body.name), json_vector(body.state.position), json_number(body.state.angle),
                       json_vector(body.state.velocity), json_number(body.state.spin),
                       is_static ? "null" : json_number(body.mass),
                       is_static ? "null" : json_number(body.moment_of_inertia));
}

std::string failure_json(const RunFailure& failure)
{
    return fmt::format("{{\"time\": {}, \"bodies\": [{}], \"message\": {}}}", json_number(failure.time),
                       fmt::join(failure.bodies, ", "), json_text(failure.message));
}

std::string handovers_json(const std::vector<Handover>& handovers)
{
    std::string items;
    for (const Handover& handover : handovers) {
        std::string bodies;
        for (const int body : handover.bodies) bodies += (bodies.empty() ? "" : ", ") + std::to_string(body);
        items += fmt::format("{}{{\"time\": {}, \"to\": \"{}\", \"bodies\": [{}], \"reason\": {}, \"ends_bounces\": {}, "
                             "\"energy_before\": {}, \"energy_after\": {}, \"energy_change\": {}}}",
                             items.empty() ? "" : ", ", json_number(handover.time),
                             handover.to == Handover::To::rest ? "rest" : "events", bodies, json_text(handover.reason),
                             handover.ends_bounces, json_number(handover.energy_before),
                             json_number(handover.energy_after), json_number(handover.energy_change));
    }
    return "[" + items + "]";
}

} // namespace

std::string json_number(double value)
{
    return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null";
}

std::string report_json(const Report& report, double wall_seconds, const std::optional<RunFailure>& failure)
{
    std::string text = "{\n";
    const auto add = [&text](const char* key, const std::string& value) {
        text += fmt::format("  \"{}\": {},\n", key, value);
    };
    add("time", json_number(report.time));
    add("engine", json_text(report.engine));
    add("events", std::to_string(report.events));
    add("collisions", std::to_string(report.collisions));
    add("handovers", std::to_string(report.handovers.size()));
    add("handover_log", handovers_json(report.handovers));
    add("energy", fmt::format("{{\"kinetic\": {}, \"potential\": {}, \"total\": {}, \"initial_total\": {}}}",
                              json_number(report.energy.kinetic), json_number(report.energy.potential),
                              json_number(report.energy.total()), json_number(report.initial_total)));
    add("energy_changes",
        fmt::format("{{\"impacts\": {}, \"steps\": {}, \"handovers\": {}}}", json_number(report.ledger.impacts),
                    json_number(report.ledger.steps), json_number(report.ledger.handovers)));
    add("momentum", json_vector(report.momentum));
    add("angular_momentum", json_number(report.angular_momentum));
    add("max_overlap", json_number(report.max_overlap));
    add("hash", fmt::format("\"{:016x}\"", report.hash));
    add("plan", plan_json(report.plan));
    add("stages", stages_json(report.stages));
    add("wall_seconds", json_number(wall_seconds));
    if (failure) add("failure", failure_json(*failure));

    std::string bodies;
    for (const BodyReport& body : report.bodies) bodies += (bodies.empty() ? "\n    " : ",\n    ") + body_json(body);
    return text + "  \"bodies\": [" + bodies + (bodies.empty() ? "" : "\n  ") + "]\n}\n";
}

} // namespace flying
