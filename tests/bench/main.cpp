// flying_bench: this engine beside Chipmunk and Box2D, scene by scene, in one run.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <ctime>
#include <set>

#include "results.hpp"

namespace {

void tell(const std::string& what)
{
    if (isatty(STDERR_FILENO)) std::fprintf(stderr, "\r\033[K%.100s", what.c_str());
}

std::string date_and_time()
{
    char text[32] = {};
    const std::time_t now = std::time(nullptr);
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
    return text;
}

} // namespace

int main(int argc, char** argv)
{
    using namespace flying::bench;
    bool all = false;
    std::set<std::string> only;
    int repeats = 5;
    double hertz = 60.0;
    double most = 30.0;
    std::optional<double> until;
    std::set<std::string> parts;
    std::string out = "out/bench";
    std::set<std::string> known;
    for (const BenchCase& bench_case : bench_cases()) known.insert(bench_case.name);
    CLI::App app("Measure this engine beside Chipmunk and Box2D");
    app.add_flag("--all", all, "The long set: every scene over its full time, all sizes");
    app.add_option("--scene", only, "Only scenes of these names")->check(CLI::IsMember(known).description(""));
    app.add_option("--part", parts, "Only these parts: scenes, growth, piles")
        ->check(CLI::IsMember({"scenes", "growth", "piles"}).description(""));
    app.add_option("--repeats", repeats, "Of each run; the median counts")->check(CLI::Range(1, 1000));
    app.add_option("--hertz", hertz, "Steps a second of the peers")->check(CLI::Range(1.0, 1e6));
    app.add_option("--most", most, "Seconds of computing after which a peer's run is given up")
        ->check(CLI::PositiveNumber);
    app.add_option("--until", until, "Simulated seconds instead of each scene's own")->check(CLI::PositiveNumber);
    app.add_option("--out", out, "Folder for bench.json, bench.txt and the data of the plots");
    CLI11_PARSE(app, argc, argv);
    if (!only.empty() && parts.empty()) parts = {"scenes"};
    const auto wants = [&](const std::string& part) { return parts.empty() || parts.contains(part); };

    Results results;
    results.machine = this_machine();
    results.started = date_and_time();
    if (wants("scenes")) {
        for (const BenchCase& bench_case : bench_cases()) {
            const double length = until.value_or(all || !only.empty() ? bench_case.until : bench_case.short_until);
            if (only.empty() ? length <= 0.0 : !only.contains(bench_case.name)) continue;
            results.scenes.push_back(compare(bench_case, length, repeats, hertz, most, tell));
            write_results(results, out);
        }
    }
    if (wants("growth")) results.growths = measure_growth(all ? Extent::full : Extent::brief, tell);
    if (wants("piles")) {
        write_results(results, out);
        results.piles = measure_piles(all ? Extent::full : Extent::brief, std::max(15, repeats), tell);
    }
    write_results(results, out);
    tell("");
    std::fputs(table(results).c_str(), stdout);

    // A run that could not go on is no result
    int failures = 0;
    for (const Comparison& comparison : results.scenes) {
        for (const Showing& showing : comparison.showings) failures += showing.failure.empty() ? 0 : 1;
    }
    return failures == 0 ? 0 : 1;
}
