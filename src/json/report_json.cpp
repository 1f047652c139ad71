#include "json/report_json.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "json/hexadecimal.hpp"

namespace flying {

namespace {

using Json = nlohmann::ordered_json;

/// On one line, each number with the 17 digits that name a double; what is no UTF-8 becomes a question mark.
std::string line_of(const Json& json)
{
    if (json.is_number_float()) {
        const auto value = json.get<double>();
        char digits[32];
        std::snprintf(digits, sizeof digits, "%.17g", value);
        return std::isfinite(value) ? digits : "null";
    }
    if (!json.is_structured()) return json.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string text;
    for (const auto& [key, value] : json.items())
        text += (text.empty() ? "" : ", ") + (json.is_object() ? line_of(Json(key)) + ": " : "") + line_of(value);
    return json.is_object() ? "{" + text + "}" : "[" + text + "]";
}

/// Between brackets, each on a line of its own.
std::string lines_of(const Json& list)
{
    std::string text;
    for (const Json& entry : list) text += (text.empty() ? "\n    " : ",\n    ") + line_of(entry);
    return "[" + text + (text.empty() ? "]" : "\n  ]");
}

Json vector(const Vec2& v)
{
    return Json::array({v.x(), v.y()});
}

const char* class_letter(SkipClass kind)
{
    return kind == SkipClass::neutral ? "N" : kind == SkipClass::ordered ? "O" : "A";
}

Json plan_json(const Plan& plan)
{
    Json skips = Json::array();
    for (const Skip& skip : plan.skips) {
        skips.push_back({{"name", skip.name},
                         {"class", class_letter(skip.kind)},
                         {"active", skip.active},
                         {"reason", skip.reason},
                         {"saved", skip.saved},
                         {"unit", skip.saved_unit}});
    }
    return {{"pair_finder", plan.pair_finder == PairFinder::grid ? "grid" : "all pairs"}, {"skips", skips}};
}

Json stages_json(const std::vector<StageCost>& stages)
{
    Json json = Json::object();
    for (const StageCost& stage : stages) json[stage.name] = {{"count", stage.count}, {"seconds", stage.seconds}};
    return json;
}

Json rest_json(const RestAccount& rest)
{
    return {{"islands", rest.islands},     {"solved", rest.solved},
            {"swept", rest.swept},         {"unsolved", rest.unsolved},
            {"parts", rest.parts},         {"projected", rest.projected},
            {"limited", rest.limited},     {"energy_limited", rest.energy_limited},
            {"elastic_ended", rest.elastic_ended}, {"elastic_braked", rest.elastic_braked}};
}

Json handovers_json(const std::vector<Handover>& handovers)
{
    Json json = Json::array();
    for (const Handover& handover : handovers) {
        json.push_back({{"time", handover.time},
                        {"to", handover.to == Handover::To::rest ? "rest" : "events"},
                        {"bodies", handover.bodies},
                        {"reason", handover.reason},
                        {"ends_bounces", handover.ends_bounces},
                        {"energy_before", handover.energy_before},
                        {"energy_after", handover.energy_after},
                        {"energy_change", handover.energy_change}});
    }
    return json;
}

Json bodies_json(const std::vector<BodyReport>& bodies)
{
    Json json = Json::array();
    for (const BodyReport& body : bodies) {
        const bool is_static = body.mass == 0.0;
        json.push_back({{"name", body.name},
                        {"position", vector(body.state.position)},
                        {"angle", body.state.angle},
                        {"velocity", vector(body.state.velocity)},
                        {"spin", body.state.spin},
                        {"mass", is_static ? Json() : Json(body.mass)},
                        {"inertia", is_static ? Json() : Json(body.moment_of_inertia)}});
    }
    return json;
}

} // namespace

std::string report_json(const Report& report, double wall_seconds, const std::optional<RunFailure>& failure)
{
    Json json{
        {"time", report.time},
        {"engine", report.engine},
        {"events", report.events},
        {"collisions", report.collisions},
        {"handovers", report.handovers.size()},
        {"handover_log", handovers_json(report.handovers)},
        {"energy",
         {{"kinetic", report.energy.kinetic},
          {"potential", report.energy.potential},
          {"total", report.energy.total()},
          {"initial_total", report.initial_total}}},
        {"energy_changes",
         {{"impacts", report.ledger.impacts}, {"steps", report.ledger.steps}, {"handovers", report.ledger.handovers}}},
        {"momentum", vector(report.momentum)},
        {"angular_momentum", report.angular_momentum},
        {"max_overlap", report.max_overlap},
        {"hash", hexadecimal(report.hash)},
        {"plan", plan_json(report.plan)},
        {"stages", stages_json(report.stages)},
        {"wall_seconds", wall_seconds}};
    if (!report.warnings.empty()) json["warnings"] = report.warnings;
    if (report.rest) json["rest"] = rest_json(*report.rest);
    if (failure)
        json["failure"] = {{"time", failure->time}, {"bodies", failure->bodies}, {"message", failure->message}};

    std::string text = "{\n";
    for (const auto& [key, value] : json.items()) text += "  " + line_of(key) + ": " + line_of(value) + ",\n";
    return text + "  \"bodies\": " + lines_of(bodies_json(report.bodies)) + "\n}\n";
}

} // namespace flying
