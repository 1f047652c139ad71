#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace flying::bench {
namespace {

constexpr int k_most_copies = 2000;
constexpr double k_as_wrong_as_can_be = 1e300; // JSON knows no infinity

/// One setting of one engine that is to be timed.
struct Entry
{
    std::size_t curve;
    std::size_t point;
    const Engine* engine;
    Setting setting;
    int copies = 1; ///< of the run, in one go
};

struct Glance
{
    work::PointRecord point;
    double seconds = 0.0;
    std::optional<std::string> failure;
};

/// Run once, and measure how wrong it is.
Glance look(const Trial& trial, const Engine& engine, const Setting& setting, const SweepOptions& options)
{
    Run run = engine.start(trial.scene, setting);
    Glance glance;
    Story story;
    for (const double time : trial.looks) {
        const double start = options.seconds();
        if (time > 0.0) run.advance(time);
        glance.seconds += options.seconds() - start;
        story.looks.push_back({time, run.states()});
        if (glance.seconds > options.most * trial.patience) break;
    }
    glance.failure = run.failure ? run.failure() : std::nullopt;
    if (glance.seconds > options.most * trial.patience || glance.failure) return glance;
    if (trial.asks_loads && run.loads) {
        story.loads = run.loads();
        story.knows_loads = true;
    }
    for (const Measure& measure : trial.measures) {
        const double error = measure.of(story).value_or(-1.0);
        glance.point.measures.push_back(std::isfinite(error) ? std::min(error, k_as_wrong_as_can_be)
                                                             : k_as_wrong_as_can_be);
    }
    glance.point.hertz = engine.steps(trial) ? setting.hertz : 0.0;
    return glance;
}

} // namespace

work::DiagramRecord sweep(const Trial& trial, std::span<const Engine> engines, const SweepOptions& options,
                          const std::function<void(const std::string&)>& tell)
{
    work::DiagramRecord record{
        trial.name,  trial.title, trial.why, trial.truth, static_cast<int>(trial.scene.bodies.size()),
        trial.until, {},          {}};
    for (const Measure& measure : trial.measures) record.measures.push_back(measure.name);

    // Look at each setting once: what it makes wrong, and about how long it takes
    std::vector<Entry> entries;
    for (const Engine& engine : engines) {
        if (!engine.applies(trial)) continue;
        work::CurveRecord curve{engine.name, {}, engine.why_not(trial)};
        const bool steps = engine.steps(trial);
        for (std::size_t k = 0; curve.why_not.empty() && k < (steps ? options.hertz.size() : 1); ++k) {
            const Setting setting{steps ? options.hertz[k] : 60.0};
            tell(trial.name + ": " + engine.name +
                 (steps ? ", " + std::to_string(std::lround(setting.hertz)) + " Hz" : ""));
            const Glance glance = look(trial, engine, setting, options);
            if (glance.failure) curve.why_not = *glance.failure;
            else if (glance.seconds > options.most * trial.patience && curve.points.empty()) {
                curve.why_not = "takes longer than the run allows";
            }
            if (glance.failure || glance.seconds > options.most * trial.patience) break;
            const double copies = std::ceil(options.least / std::max(glance.seconds, 1e-9));
            entries.push_back({record.curves.size(), curve.points.size(), &engine, setting,
                               static_cast<int>(std::clamp(copies, 1.0, double{k_most_copies}))});
            curve.points.push_back(glance.point);
        }
        record.curves.push_back(std::move(curve));
    }

    // Time them all in turn; what sets a run up is not timed
    std::vector<work::Prepare> prepares;
    for (const Entry& entry : entries) {
        prepares.push_back([&trial, &entry] {
            std::vector<Run> runs;
            for (int k = 0; k < entry.copies; ++k) runs.push_back(entry.engine->start(trial.scene, entry.setting));
            return [&trial, runs = std::move(runs)] {
                for (const Run& run : runs) run.advance(trial.until);
            };
        });
    }
    tell(trial.name + ": " + std::to_string(entries.size()) + " runs in turn, " + std::to_string(options.repeats) +
         " rounds");
    std::vector<std::vector<double>> times = work::time_in_turn(prepares, options.repeats, options.seconds);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        for (double& time : times[k]) time /= entries[k].copies;
        record.curves[entries[k].curve].points[entries[k].point].seconds = work::spread_of(times[k]);
    }
    return record;
}

Expected<RecordFile> RecordFile::open(const std::string& path, const work::RunRecord& run)
{
    std::string text;
    if (std::ifstream file(path, std::ios::binary); file) text.assign(std::istreambuf_iterator<char>(file), {});
    std::size_t whole = 0;
    std::optional<work::Records> records = work::read_records(text, &whole);
    if (!records && text.find('\n') != std::string::npos) {
        return Fault{path, "a file that holds no records", "the file of an earlier run; --fresh begins anew"};
    }
    if (!records) {
        const RecordFile fresh(path, work::Records{run, {}, {}, {}});
        std::filesystem::remove(path);
        fresh.append(work::line_of("run", run));
        return fresh;
    }
    const work::RunRecord& before = records->run;
    if (before.name != run.name || before.machine != run.machine || before.compiler != run.compiler ||
        before.peers != run.peers || before.repeats != run.repeats || before.most != run.most) {
        return Fault{path,
                     "a run '" + before.name + "' of " + before.date + " with other settings, versions or machine",
                     "a run like this one, to go on with; --fresh begins anew"};
    }

    // Leave out the line that was cut off
    std::filesystem::resize_file(path, whole);
    return RecordFile(path, *records);
}

bool RecordFile::has_growth(const std::string& name) const
{
    return std::any_of(records_.growths.begin(), records_.growths.end(),
                       [&](const auto& one) { return one.name == name; });
}

bool RecordFile::has_skips(const std::string& scene) const
{
    return std::any_of(records_.skips.begin(), records_.skips.end(),
                       [&](const auto& one) { return one.scene == scene; });
}

void RecordFile::add(const work::DiagramRecord& record)
{
    append(work::line_of("diagram", record));
    records_.diagrams.push_back(record);
}

void RecordFile::add(const work::GrowthRecord& record)
{
    append(work::line_of("growth", record));
    records_.growths.push_back(record);
}

void RecordFile::add(const work::SkipsRecord& record)
{
    append(work::line_of("skips", record));
    records_.skips.push_back(record);
}

void RecordFile::append(const std::string& line) const
{
    std::ofstream(path_, std::ios::app | std::ios::binary) << line << '\n' << std::flush;
}

} // namespace flying::bench
