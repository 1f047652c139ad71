#include "stress.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "scene/read.hpp"
#include "stress/random_scenes.hpp"

namespace flying::stress {
namespace {

/// What one skip saved in the scenes of one kind.
struct Saving
{
    int active = 0;
    long saved = 0;
    std::string unit;
};

std::string cell_of(const Saving& saving)
{
    if (saving.active == 0) return "no use";
    return saving.unit.empty() ? "in use" : fmt::format("{} {}", saving.saved, saving.unit);
}

/// Of the skips that may change no bit.
std::vector<std::string> neutral_names()
{
    std::vector<std::string> names;
    for (const Skip& skip : make_plan(Scene{}).skips) {
        if (skip.kind != SkipClass::altering) names.push_back(skip.name);
    }
    return names;
}

using Table = std::vector<std::pair<std::string, std::map<std::string, Saving>>>;

void print_table(const Table& table, const std::string& corner, Tally& tally)
{
    std::string head = "| " + corner + " |";
    std::string rule = "|---|";
    for (const std::string& skip : skip_names()) {
        head += " " + skip + " |";
        rule += "---|";
    }
    tally.note(head);
    tally.note(rule);
    for (const auto& [name, savings] : table) {
        std::string line = "| " + name + " |";
        for (const std::string& skip : skip_names()) {
            const auto found = savings.find(skip);
            line += " " + (found == savings.end() ? "no use" : cell_of(found->second)) + " |";
        }
        tally.note(line);
    }
}

void add(std::map<std::string, Saving>& savings, const std::vector<Skip>& skips)
{
    for (const Skip& skip : skips) {
        Saving& saving = savings[skip.name];
        saving.active += skip.active ? 1 : 0;
        saving.saved += skip.active ? skip.saved : 0;
        saving.unit = skip.saved_unit;
    }
}

} // namespace

void run_skips(const Job& job, Tally& tally)
{
    Table table;
    for (int kind = 0; kind < k_scene_kinds; ++kind) table.emplace_back(name_of(static_cast<SceneKind>(kind)), std::map<std::string, Saving>{});
    std::map<std::string, long> compared;
    std::map<std::string, long> wrong;
    long impacts = 0;
    for (long k = 0; k < job.count; ++k) {
        const std::uint64_t seed = job.seed + static_cast<std::uint64_t>(k);
        const Scene scene = random_scene(seed);
        const Trace plain = trace_of(scene, {});
        impacts += static_cast<long>(plain.moments.size());
        add(table[static_cast<std::size_t>(kind_of(seed))].second, plain.skips);

        // A skip that has no use in a scene can't be turned off there
        for (const Skip& skip : plain.skips) {
            if (!skip.active || skip.kind == SkipClass::altering) continue;
            ++compared[skip.name];
            const std::string off = difference(plain, trace_of(scene, {skip.name}));
            if (off.empty()) continue;
            if (++wrong[skip.name] <= 5) tally.note(fmt::format("        scene {} without {}: {}", seed, skip.name, off));
        }
        tally.progress(fmt::format("skips: {} of {} scenes, {} impacts", k + 1, job.count, impacts));
        if (k % 1000 == 999) tally.note(fmt::format("        skips: seeds {} to {} done, {} impacts", job.seed, seed, impacts));
    }
    for (const std::string& skip : neutral_names()) {
        tally.result(wrong[skip] == 0 && compared[skip] > 0,
                     fmt::format("skips: without {}, {} of {} scenes differ in a bit after some impact (seeds {} to {}, {} impacts in all)",
                                 skip, wrong[skip], compared[skip], job.seed, job.seed + static_cast<std::uint64_t>(job.count) - 1, impacts));
    }
    print_table(table, "work left out in random scenes", tally);
}

void run_savings(const Job& job, Tally& tally)
{
    // The scenes of the chapters, each for so many impacts
    namespace files = std::filesystem;
    std::vector<files::path> paths;
    for (const auto& entry : files::directory_iterator(FLYING_SOURCE_DIR "/chapters/scenes")) {
        if (entry.path().extension() == ".toml") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    Table table;
    long scenes = 0;
    for (const files::path& path : paths) {
        const Expected<Scene> scene = read_scene_file(path.string());
        if (!scene) continue;
        const Trace trace = trace_of(scene.value(), {}, static_cast<std::size_t>(job.count));
        auto& row = table.emplace_back(fmt::format("{}, {} impacts", path.stem().string(), trace.moments.size()), std::map<std::string, Saving>{});
        add(row.second, trace.skips);
        ++scenes;
    }
    tally.result(scenes > 0, fmt::format("savings: {} scenes of the chapters, for {} impacts or to their end", scenes, job.count));
    print_table(table, "work left out", tally);
}

} // namespace flying::stress
