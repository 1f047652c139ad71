#include "results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace flying::bench {
namespace {

using nlohmann::json;

const Showing* chipmunk_of(const Comparison& comparison)
{
    for (const Showing& showing : comparison.showings) {
        if (showing.engine.kind == EngineChoice::Kind::chipmunk) return &showing;
    }
    return nullptr;
}

std::string label(const EngineChoice& engine)
{
    return engine.hertz > 0.0 ? fmt::format("{} {:.0f} Hz", name_of(engine.kind), engine.hertz) : name_of(engine.kind);
}

std::string row(const Comparison& comparison, const Showing& showing)
{
    if (showing.stopped_at) {
        return fmt::format("{:<20} {:>15} stopped after {:.0f} s, at {:.2f} s of {:g}\n", comparison.name,
                           label(showing.engine), showing.seconds.back(), *showing.stopped_at, comparison.until);
    }
    const double seconds = median(showing.seconds);
    const Showing* chipmunk = chipmunk_of(comparison);
    const std::string ratio =
        chipmunk && !chipmunk->stopped_at ? fmt::format("{:.3f}", seconds / median(chipmunk->seconds)) : "";
    const std::string error = showing.path_error ? fmt::format("{:.1e}", *showing.path_error) : "";
    const std::string rate =
        showing.collisions > 0 ? fmt::format("{:.3g}", static_cast<double>(showing.collisions) / seconds) : "";
    return fmt::format("{:<20} {:>15} {:>9.4f} {:>8} {:>8.3f} {:>9.1e} {:>8.1e} {:>8} {:>10}{}\n", comparison.name,
                       label(showing.engine), seconds, ratio, showing.setup_seconds, showing.drift, showing.overlap,
                       error, rate, showing.failure.empty() ? "" : "  FAILED: " + showing.failure);
}

json json_of(const Comparison& comparison)
{
    json scene = {{"name", comparison.name},
                  {"aim", comparison.aim},
                  {"bodies", comparison.bodies},
                  {"simulated_seconds", comparison.until},
                  {"overlap_samples_per_second", comparison.samples_hertz},
                  {"exact_path", comparison.exact_path},
                  {"exact_path_error_m", comparison.exact_path_error}};
    const Showing* chipmunk = chipmunk_of(comparison);
    for (const Showing& showing : comparison.showings) {
        json engine = {{"name", name_of(showing.engine.kind)},         {"hertz", showing.engine.hertz},
                       {"seconds", median(showing.seconds)},           {"seconds_each", showing.seconds},
                       {"wall_seconds", median(showing.wall_seconds)}, {"wall_seconds_each", showing.wall_seconds},
                       {"setup_seconds", showing.setup_seconds},       {"energy_drift", showing.drift},
                       {"deepest_overlap_m", showing.overlap}};
        if (showing.stopped_at) engine["stopped_at"] = *showing.stopped_at;
        else if (chipmunk && !chipmunk->stopped_at)
            engine["ratio_to_chipmunk"] = median(showing.seconds) / median(chipmunk->seconds);
        if (showing.path_error) engine["path_error_m"] = *showing.path_error;
        if (showing.collisions > 0) engine["collisions"] = showing.collisions;
        if (!showing.failure.empty()) engine["failure"] = showing.failure;
        scene["engines"].push_back(engine);
    }
    return scene;
}

json json_of(const PileComparison& comparison)
{
    json pile = {{"name", comparison.name},
                 {"hertz", 60},
                 {"settled_steps", comparison.settled},
                 {"asleep_share", comparison.asleep_after},
                 {"asleep_step_us", comparison.asleep_micros}};
    if (comparison.asleep_at >= 0.0) pile["asleep_at_s"] = comparison.asleep_at;
    const double chipmunk = comparison.showings.front().milliseconds;
    for (const PileShowing& showing : comparison.showings) {
        pile["engines"].push_back({{"name", showing.engine},
                                   {"step_ms", showing.milliseconds},
                                   {"worst_step_ms", showing.worst},
                                   {"ratio_to_chipmunk", showing.milliseconds / chipmunk},
                                   {"touching_pairs", showing.touching},
                                   {"mean_overlap_radii", showing.mean_overlap},
                                   {"worst_overlap_radii", showing.worst_overlap}});
    }
    return pile;
}

std::string rows(const PileComparison& comparison)
{
    std::string text;
    const double chipmunk = comparison.showings.front().milliseconds;
    long most = 1;
    for (const PileShowing& showing : comparison.showings) most = std::max(most, showing.touching);
    for (const PileShowing& showing : comparison.showings) {
        // Box2D keeps many pairs a skin apart
        const bool tells = 2 * showing.touching > most;
        const double a_pair = 1e6 * showing.milliseconds / static_cast<double>(std::max(1l, showing.touching));
        text += fmt::format("{:<20} {:>15} {:>9.4f} {:>8.3f} {:>9.2f} {:>9} {:>8.1e} {:>8.1e} {:>10}\n",
                            comparison.name, showing.engine, showing.milliseconds, showing.milliseconds / chipmunk,
                            showing.worst, showing.touching, showing.mean_overlap, showing.worst_overlap,
                            tells ? fmt::format("{:.0f}", a_pair) : "");
    }
    if (comparison.asleep_at >= 0.0) {
        text += fmt::format("{:<20} with sleep: all asleep after {:.1f} s, then {:.3f} us a step\n", "",
                            comparison.asleep_at, comparison.asleep_micros);
    } else {
        text += fmt::format("{:<20} with sleep: {:.1f} % asleep in the end\n", "", 100.0 * comparison.asleep_after);
    }
    return text;
}

json json_of(const Results& results)
{
    const Machine& machine = results.machine;
    json all = {
        {"started", results.started},
        {"machine", {{"cpu", machine.cpu}, {"cores", machine.cores}}},
        {"compiler", machine.compiler},
        {"flags", machine.flags},
        {"peers", {machine.chipmunk, machine.box2d}},
        {"note",
         "seconds are of computing on one thread, medians; the peers are the distribution's, with assertions on"}};
    for (const Comparison& comparison : results.scenes) all["scenes"].push_back(json_of(comparison));
    for (const Growth& growth : results.growths) {
        json entry = {
            {"name", growth.name}, {"what", growth.what}, {"slope", growth.all.slope}, {"end_slope", growth.end.slope}};
        for (const Rate& rate : growth.rates) {
            entry["rates"].push_back(
                {{"size", rate.size}, {"events_per_second", rate.events}, {"collisions_per_second", rate.collisions}});
        }
        all["growth"].push_back(entry);
    }
    for (const PileComparison& comparison : results.piles) all["piles"].push_back(json_of(comparison));
    return all;
}

/// Whole or not at all.
void write_file(const std::filesystem::path& path, const std::string& text)
{
    const std::filesystem::path unfinished = path.string() + ".part";
    std::ofstream(unfinished) << text;
    std::filesystem::rename(unfinished, path);
}

} // namespace

std::string table(const Results& results)
{
    const Machine& machine = results.machine;
    std::string text =
        fmt::format("{} ({} cores), {}, {}\n{}\n{}\nSeconds of computing on one thread, medians, setting "
                    "up apart; error: median distance from the exact places after 1 s.\n\n",
                    machine.cpu, machine.cores, machine.compiler, machine.flags, machine.chipmunk, machine.box2d);
    text += fmt::format("{:<20} {:>15} {:>9} {:>8} {:>8} {:>9} {:>8} {:>8} {:>10}\n", "scene", "engine", "seconds",
                        "/Chipm.", "setup s", "drift", "overlap", "error m", "impacts/s");
    for (const Comparison& comparison : results.scenes) {
        for (const Showing& showing : comparison.showings) text += row(comparison, showing);
        text += fmt::format("{:<20} {:g} s, median of {}; aim {}", "", comparison.until,
                            comparison.showings.front().seconds.size(), comparison.aim);
        if (!comparison.exact_path.empty()) {
            text += fmt::format("; exact path known to {:.0e} m", comparison.exact_path_error);
        }
        text += "\n";
    }
    for (const Growth& growth : results.growths) {
        text += fmt::format("\n{}: slope {:.2f}, of the larger half {:.2f}\n", growth.what, growth.all.slope,
                            growth.end.slope);
        for (const Rate& rate : growth.rates) {
            text += fmt::format("{:>9} {:>10.3g} collisions/s {:>10.3g} events/s\n", rate.size, rate.collisions,
                                rate.events);
        }
    }
    if (!results.piles.empty()) {
        text += fmt::format("\nAt rest: steps of 1/60 s, no body sleeps; overlaps in radii\n{:<20} {:>15} {:>9} {:>8} "
                            "{:>9} {:>9} {:>8} {:>8} {:>10}\n",
                            "scene", "engine", "ms a step", "/Chipm.", "worst ms", "touching", "mean", "deepest",
                            "ns a pair");
    }
    for (const PileComparison& comparison : results.piles) text += rows(comparison);
    return text;
}

void write_results(const Results& results, const std::filesystem::path& folder)
{
    std::filesystem::create_directories(folder);
    write_file(folder / "bench.json", json_of(results).dump(2) + "\n");
    write_file(folder / "bench.txt", table(results));

    // For the plots, which are drawn of whatever has been measured
    write_file(folder / "machine.ini", fmt::format("machine = \"{}\"\n", results.machine.cpu));
    std::string settings;
    for (const Growth& growth : results.growths) {
        std::string data = "# size collisions/s events/s\n";
        for (const Rate& rate : growth.rates) {
            data += fmt::format("{} {:.6g} {:.6g}\n", rate.size, rate.collisions, rate.events);
        }
        write_file(folder / (growth.name + ".dat"), data);
        std::string name = growth.name;
        for (char& letter : name) letter = letter == '-' ? '_' : letter;
        settings +=
            fmt::format("slope_{0} = {1:.6g}\nfactor_{0} = {2:.6g}\n", name, growth.all.slope, growth.all.factor);
        settings += fmt::format("end_slope_{0} = {1:.6g}\nend_factor_{0} = {2:.6g}\n", name, growth.end.slope,
                                growth.end.factor);
    }
    if (!results.growths.empty()) write_file(folder / "growth.ini", settings);
}

} // namespace flying::bench
