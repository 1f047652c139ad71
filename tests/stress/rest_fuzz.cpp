#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

#include "rest_trial.hpp"

using namespace flying::stress;

namespace {

int usage()
{
    std::fputs("usage: flying_rest_fuzz --seeds A..B [--auto] [--verbose]\n"
               "Runs the random scenes of the seeds A to B, both included; exit status 1 where one breaks a promise.\n",
               stderr);
    return 2;
}

void print(long seed, const RestScene& scene, const RestFindings& f, double seconds)
{
    std::printf("seed %ld: rise %.1e (step %d), overlap %.1e (step %d, %d on %d), at the end %.1e, lost %d%s, %.2f s; %s\n", seed,
                f.rise, f.rise_step, f.overlap, f.overlap_step, f.overlap_a, f.overlap_b, f.end_overlap, f.lost,
                f.finite ? "" : ", not finite", seconds, scene.label.c_str());
    const flying::RestAccount& rest = f.rest;
    const auto count = [](std::int64_t number) { return static_cast<long long>(number); };
    std::printf("    islands %lld, unsolved %lld, projected %lld, limited %lld by %.1e J\n", count(rest.islands),
                count(rest.unsolved), count(rest.projected), count(rest.limited), rest.energy_limited);
    std::fflush(stdout);
}

} // namespace

int main(int count, char** words)
{
    long first = -1;
    long last = -1;
    bool verbose = false;
    Integrator integrator = Integrator::rest;
    for (int k = 1; k < count; ++k) {
        if (std::strcmp(words[k], "--verbose") == 0) verbose = true;
        else if (std::strcmp(words[k], "--auto") == 0) integrator = Integrator::automatic;
        else if (std::strcmp(words[k], "--seeds") == 0 && k + 1 < count) {
            if (std::sscanf(words[++k], "%ld..%ld", &first, &last) == 1) last = first;
        } else return usage();
    }
    if (first < 0 || last < first) return usage();

    long failed = 0;
    double rise = 0.0;
    double overlap = 0.0;
    for (long seed = first; seed <= last; ++seed) {
        const RestScene scene = make_rest_scene(static_cast<std::uint64_t>(seed));
        const std::clock_t start = std::clock();
        const RestFindings findings = run_rest_scene(scene, 1, integrator);
        const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
        const bool good = passes(findings);
        failed += good ? 0 : 1;
        rise = std::max(rise, findings.rise);
        overlap = std::max(overlap, findings.overlap);
        if (verbose || !good) print(seed, scene, findings, seconds);
    }
    std::printf("%ld scenes, %ld failed; worst rise %.1e, worst overlap %.1e\n", last - first + 1, failed, rise, overlap);
    return failed > 0 ? 1 : 0;
}
