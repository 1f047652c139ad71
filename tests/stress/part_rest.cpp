#include "stress.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "rest_trial.hpp"

namespace flying::stress {

void run_rest(const Job& job, Tally& tally)
{
    // Each scene runs for 5 s, by the engine that people run and by the resting integrator alone, which promises less:
    // bodies that fly further than a quarter of their size in a step may end in each other. A scene that breaks a
    // promise gets a line
    double rise = 0.0;
    double overlap = 0.0;
    double end_overlap = 0.0;
    long lost = 0;
    long not_finite = 0;
    long ends = 0;
    long ends_alone = 0;
    long lost_alone = 0;
    RestAccount sum;
    const std::uint64_t end = job.seed + static_cast<std::uint64_t>(job.count);
    for (std::uint64_t seed = job.seed; seed < end; ++seed) {
        tally.progress(fmt::format("rest: seed {} of {} to {}, {} that lost a body, {} that end with overlap", seed,
                                   job.seed, end - 1, lost, ends));
        const RestScene scene = make_rest_scene(seed);
        for (const Integrator integrator : {Integrator::automatic, Integrator::rest}) {
            const RestFindings findings = run_rest_scene(scene, 10, integrator);
            const bool is_alone = integrator == Integrator::rest;
            rise = std::max(rise, findings.rise);
            (is_alone ? lost_alone : lost) += findings.lost > 0 ? 1 : 0;
            not_finite += findings.finite ? 0 : 1;
            (is_alone ? ends_alone : ends) += findings.end_overlap > k_overlap_allowed ? 1 : 0;
            if (!is_alone) {
                overlap = std::max(overlap, findings.overlap);
                end_overlap = std::max(end_overlap, findings.end_overlap);
                sum.islands += findings.rest.islands;
                sum.swept += findings.rest.swept;
                sum.unsolved += findings.rest.unsolved;
                sum.parts += findings.rest.parts;
                sum.projected += findings.rest.projected;
                sum.limited += findings.rest.limited;
            }
            if (!ends_well(findings))
                tally.note(fmt::format(
                    "        rest: seed {}{}: {} lost, overlap at the end {:.1e} sizes, rise {:.1e}; {}", seed,
                    is_alone ? ", alone" : "", findings.lost, findings.end_overlap, findings.rise, scene.label));
        }
    }
    const std::string what = fmt::format("rest: {} scenes from seed {}", job.count, job.seed);
    tally.result(not_finite == 0, fmt::format("{}: {} with a number that is none", what, not_finite));
    tally.result(lost == 0, fmt::format("{}: {} that lost a body", what, lost));
    tally.result(rise <= k_rise_allowed, fmt::format("{}: energy never rises, at most by {:.1e} of all", what, rise));
    tally.result(ends == 0,
                 fmt::format("{}: {} that end with overlap beyond a hundredth of the smaller size, at most {:.1e}",
                             what, ends, end_overlap));
    tally.note(fmt::format("        rest: deepest overlap at any tenth step {:.1e} sizes", overlap));
    tally.note(fmt::format("        rest: by the resting integrator alone {} lose a body, {} end with overlap",
                           lost_alone, ends_alone));
    tally.note(fmt::format("        rest: of {} islands' steps {} swept, {} made in parts, {} projected, {} limited, "
                           "{} without a solution",
                           sum.islands, sum.swept, sum.parts, sum.projected, sum.limited, sum.unsolved));
}

} // namespace flying::stress
