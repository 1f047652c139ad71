#pragma once

#include <cstdio>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "precision.hpp"
#include "spread.hpp"

/// What a run of the benchmarks wrote down: one object a line, so that a run that was cut off keeps every line but the
/// last.
namespace flying::work {

/// Where and with what everything in a file was measured: its first line.
struct RunRecord
{
    std::string name;               ///< such as "quick"
    std::string date;               ///< when it began
    std::string machine;            ///< the processor, and how many cores it has
    std::string compiler;           ///< with version and flags
    std::vector<std::string> peers; ///< name, version, how they were built
    int repeats = 0;                ///< rounds of each diagram
    double most = 0.0;              ///< settings whose run takes longer are left out [s]
};

/// One setting of one engine: a point of its curve.
struct PointRecord
{
    double hertz = 0.0;           ///< steps a second; 0 where there are none [1/s]
    Spread seconds;               ///< of computing, over all repeats [s]
    std::vector<double> measures; ///< what each of the diagram's measures says
};

struct CurveRecord
{
    std::string engine;
    std::vector<PointRecord> points;
    std::string why_not; ///< why the engine can't do this; empty where it can
};

/// One scene: what was measured, and what every engine reached.
struct DiagramRecord
{
    std::string name;
    std::string title;
    std::string why;   ///< why that error
    std::string truth; ///< what it is measured against
    int bodies = 0;
    double until = 0.0;                ///< simulated [s]
    std::vector<std::string> measures; ///< with their units; the first is the diagram's error
    std::vector<CurveRecord> curves;
};

/// Time against size.
struct GrowthRecord
{
    std::string name;
    std::string title;
    std::string what;                                                     ///< what the seconds are for
    std::map<std::string, std::vector<std::pair<double, double>>> curves; ///< engine: size and seconds
    std::map<std::string, double> bytes_per_body;                         ///< engine: held after its largest run [B]
};

/// One scene with each of its skips turned off in turn. The first entry has none turned off.
struct SkipsRecord
{
    struct Entry
    {
        std::string without;
        Spread seconds;
        long long saved = 0; ///< how often the work was left out, as the engine counts it
        bool same_bits = true;
        bool alters = false; ///< the skip is one that may change results
    };
    std::string scene;
    double until = 0.0; ///< simulated [s]
    std::vector<Entry> entries;
};

/// Everything that a file holds.
struct Records
{
    RunRecord run;
    std::vector<DiagramRecord> diagrams;
    std::vector<GrowthRecord> growths;
    std::vector<SkipsRecord> skips;

    [[nodiscard]] const DiagramRecord* diagram(const std::string& name) const
    {
        for (const DiagramRecord& one : diagrams)
            if (one.name == name) return &one;
        return nullptr;
    }
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Spread, low, median, high)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunRecord, name, date, machine, compiler, peers, repeats, most)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PointRecord, hertz, seconds, measures)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CurveRecord, engine, points, why_not)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DiagramRecord, name, title, why, truth, bodies, until, measures, curves)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GrowthRecord, name, title, what, curves, bytes_per_body)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SkipsRecord::Entry, without, seconds, saved, same_bits, alters)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SkipsRecord, scene, until, entries)

/// One line of a file, without its end.
template <typename Record>
[[nodiscard]] std::string line_of(const char* kind, const Record& record)
{
    return nlohmann::json{{kind, record}}.dump();
}

/// The records in a text of lines. What follows the last end of a line was cut off and is left out.
/// whole  is told how many characters hold whole lines; may be null
/// Nothing where a whole line is no record, or the first is not that of a run.
[[nodiscard]] inline std::optional<Records> read_records(const std::string& text, std::size_t* whole = nullptr)
{
    Records records;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
        const nlohmann::json line = nlohmann::json::parse(text.substr(begin, end - begin), nullptr, false);
        if (!line.is_object() || (begin == 0) != line.contains("run")) return std::nullopt;
        if (line.contains("run")) line.at("run").get_to(records.run);
        if (line.contains("diagram")) records.diagrams.push_back(line.at("diagram"));
        if (line.contains("growth")) records.growths.push_back(line.at("growth"));
        if (line.contains("skips")) records.skips.push_back(line.at("skips"));
        begin = end + 1;
    }
    if (whole) *whole = begin;
    return begin == 0 ? std::nullopt : std::optional(records);
}

/// The same from a file; nothing where it can't be read.
[[nodiscard]] inline std::optional<Records> read_record_file(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return read_records(std::string(std::istreambuf_iterator<char>(file), {}));
}

/// The same for a program that can't go on without them: says so where there are none.
[[nodiscard]] inline std::optional<Records> read_kept_run(const char* path)
{
    std::optional<Records> records = read_record_file(path);
    if (!records) std::fprintf(stderr, "%s: found no records; expected the file of a run of ./course bench\n", path);
    return records;
}

/// With what it was run, and the peers.
inline void print_with_what(const RunRecord& run)
{
    std::printf("%s\n%s\n", run.machine.c_str(), run.compiler.c_str());
    for (const std::string& peer : run.peers) std::printf("%s\n", peer.c_str());
}

/// The points of one engine's curve by the measure of this number; none where it has no curve.
[[nodiscard]] inline std::vector<Point> points_of(const DiagramRecord& diagram, const std::string& engine,
                                                  std::size_t measure = 0)
{
    std::vector<Point> points;
    for (const CurveRecord& curve : diagram.curves) {
        if (curve.engine != engine) continue;
        for (const PointRecord& point : curve.points) {
            points.push_back({point.seconds.median, point.measures.at(measure)});
        }
    }
    return points;
}

/// Ours: those of the whole simulator, and where it took longer than the run allows, of its steps alone.
[[nodiscard]] inline std::vector<Point> our_points(const DiagramRecord& diagram)
{
    const std::vector<Point> whole = points_of(diagram, "flying");
    return whole.empty() ? points_of(diagram, "flying, steps only") : whole;
}

/// An engine that isn't ours, among those that are compared with it.
[[nodiscard]] inline bool is_peer(const std::string& engine)
{
    return engine.starts_with("Box2D") || engine.starts_with("Chipmunk") || engine.starts_with("Siconos");
}

/// A diagram of whole engines, not one of small kernels.
[[nodiscard]] inline bool is_race(const DiagramRecord& diagram)
{
    return !our_points(diagram).empty();
}

} // namespace flying::work
