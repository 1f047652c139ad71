// flying_diagrams: time against error, scene by scene, engine by engine; growth; skips. What is measured stands in a
// file of lines that grows as it goes, and a run that was cut off goes on with the first that is missing.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <set>

#include "14-time-against-error/diagram.hpp"
#include "engine.hpp"
#include "growth_sweep.hpp"
#include "machine.hpp"
#include "numbers.hpp"
#include "sweep.hpp"

namespace {

using namespace flying::bench;
namespace work = flying::work;

void tell(const std::string& what)
{
    if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r\033[K%.100s", what.c_str());
}

std::string today()
{
    char text[32] = {};
    const std::time_t now = std::time(nullptr);
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

std::vector<Engine> all_engines()
{
    std::vector<Engine> engines = {own_engine(true), own_awake(), own_steps()};
    for (Engine& one : steppers()) engines.push_back(std::move(one));
    for (Engine& one : peers()) engines.push_back(std::move(one));
    return engines;
}

/// One line for people: our time over the best peer's, from the largest error that a peer reaches to the smallest.
void print(const work::DiagramRecord& diagram)
{
    std::printf("%-18s", diagram.name.c_str());
    const std::vector<work::Point> ours = work::our_points(diagram);
    for (const work::Point& point : ours) std::printf(" %.2g s %.1e |", point.seconds, point.error);
    std::printf(" over the best peer's:");
    double last = -1.0;
    for (const work::Ratio& ratio : work::ratios(ours, work::peers_points(diagram))) {
        if (ratio.error == last) continue;
        last = ratio.error;
        if (ratio.ours_over_theirs) std::printf(" %.2g at %.0e", *ratio.ours_over_theirs, ratio.error);
        else std::printf(" - at %.0e", ratio.error);
    }
    std::printf("\n");
    std::fflush(stdout);
}

void draw(const work::Records& records, const std::string& out)
{
    for (const work::DiagramRecord& diagram : records.diagrams) {
        for (std::size_t k = 0; k < diagram.measures.size(); ++k) {
            const std::string name = "/work-" + diagram.name + (k == 0 ? "" : "-" + std::to_string(k + 1)) + ".svg";
            work::draw_diagram(out + name, diagram, k);
        }
    }
    for (const work::GrowthRecord& growth : records.growths)
        work::draw_growth(out + "/growth-" + growth.name + ".svg", growth);
    if (!records.diagrams.empty()) work::draw_ratios(out + "/work-ratios.svg", records);
    if (!records.skips.empty()) work::draw_skips(out + "/skips.svg", records);
}

} // namespace

int main(int argc, char** argv)
{
    bool quick = false;
    bool fresh = false;
    std::optional<int> repeats;
    std::optional<double> most;
    std::string out = "out/bench";
    std::string scenes = "chapters/scenes";
    std::set<std::string> only;
    std::set<std::string> known;
    for (const TrialMaker& maker : trial_makers()) known.insert(maker.name);
    for (const TrialMaker& maker : number_trials()) known.insert(maker.name);
    for (const std::string& name : growth_names()) known.insert("growth-" + name);
    known.insert("skips");
    CLI::App app("Time against error");
    app.add_flag("--quick", quick, "All plots coarsely: fewer bodies, steps and repeats");
    app.add_flag("--fresh", fresh, "Leave an earlier run's file and begin anew");
    app.add_option("--only", only, "Only these")->check(CLI::IsMember(known).description(""));
    app.add_option("--repeats", repeats, "Of each run; median and quartiles count")->check(CLI::Range(1, 1000));
    app.add_option("--most", most, "Seconds of computing that one run may take")->check(CLI::PositiveNumber);
    app.add_option("--out", out, "Folder for the lines and the plots");
    app.add_option("--scenes", scenes, "Folder of the scenes whose skips are weighed");
    CLI11_PARSE(app, argc, argv);

    const Machine machine = this_machine();
    work::RunRecord run{quick ? "quick" : "full",
                        today(),
                        machine.cpu + ", " + std::to_string(machine.cores) + " cores",
                        machine.compiler + ", " + machine.flags,
                        {machine.chipmunk, machine.box2d, machine.siconos},
                        repeats.value_or(quick ? 5 : 30),
                        most.value_or(quick ? 0.1 : 0.2)};
    std::filesystem::create_directories(out);
    const std::string path = out + "/" + run.name + ".jsonl";
    if (fresh) std::filesystem::remove(path);
    flying::Expected<RecordFile> opened = RecordFile::open(path, run);
    if (!opened) {
        const flying::Fault& fault = opened.faults().front();
        std::fprintf(stderr, "%s: found %s; expected %s\n", fault.place.c_str(), fault.found.c_str(),
                     fault.expected.c_str());
        return 2;
    }
    RecordFile& file = opened.value();

    SweepOptions options;
    options.repeats = run.repeats;
    options.most = run.most;
    options.seconds = cpu_seconds;
    for (double hertz = 60.0; hertz <= 15360.0; hertz *= quick ? 4.0 : 2.0) options.hertz.push_back(hertz);
    const std::vector<Engine> engines = all_engines();
    const Coarseness coarseness = quick ? Coarseness::quick : Coarseness::full;
    const auto is_wanted = [&](const std::string& name) { return only.empty() || only.contains(name); };
    for (const TrialMaker& maker : trial_makers()) {
        if (!is_wanted(maker.name) || file.has_diagram(maker.name)) continue;
        tell(maker.name + ": truth");
        file.add(sweep(maker.make(coarseness), engines, options, tell));
        tell("");
        print(file.records().diagrams.back());
    }
    // Two small kernels reach what floats can do only at many more steps
    SweepOptions finer = options;
    for (double hertz = 61440.0; hertz <= 245760.0; hertz *= quick ? 4.0 : 2.0) finer.hertz.push_back(hertz);
    for (const TrialMaker& maker : number_trials()) {
        if (!is_wanted(maker.name) || file.has_diagram(maker.name)) continue;
        file.add(sweep(maker.make(coarseness), number_engines(), finer, tell));
        tell("");
        std::printf("%s: done\n", maker.name.c_str());
    }
    for (const std::string& name : growth_names()) {
        if (!is_wanted("growth-" + name) || file.has_growth(name)) continue;
        file.add(grow(name, coarseness, quick ? 0.3 : 6.0, quick ? 1 : 3, tell));
        tell("");
        std::printf("growth-%s: done\n", name.c_str());
        std::fflush(stdout);
    }
    if (is_wanted("skips")) {
        std::set<std::string> files;
        for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
            if (entry.path().extension() == ".toml") files.insert(entry.path().string());
        }
        for (const std::string& scene : files) {
            if (file.has_skips(std::filesystem::path(scene).stem().string())) continue;
            file.add(weigh_skips(scene, quick ? 0.5 : 2.0, quick ? 3 : 9, tell));
            tell("");
            std::printf("skips of %s: done\n", file.records().skips.back().scene.c_str());
            std::fflush(stdout);
        }
    }
    draw(file.records(), out);
    std::printf("%s\n", path.c_str());
    return 0;
}
