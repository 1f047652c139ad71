#include "stress.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "rest_trial.hpp"

namespace flying::stress {

void run_rest(const Job& job, Tally& tally)
{
    // Each scene runs for 5 s; those that break a promise get a line each, for a seed of their own
    double rise = 0.0;
    double overlap = 0.0;
    double end_overlap = 0.0;
    long lost = 0;
    long not_finite = 0;
    long ends = 0;
    const std::uint64_t end = job.seed + static_cast<std::uint64_t>(job.count);
    for (std::uint64_t seed = job.seed; seed < end; ++seed) {
        tally.progress(fmt::format("rest: seed {} of {} to {}, {} that lost a body, {} that end with overlap", seed, job.seed,
                                   end - 1, lost, ends));
        const RestScene scene = make_rest_scene(seed);
        const RestFindings findings = run_rest_scene(scene);
        rise = std::max(rise, findings.rise);
        overlap = std::max(overlap, findings.overlap);
        end_overlap = std::max(end_overlap, findings.end_overlap);
        lost += findings.lost > 0 ? 1 : 0;
        not_finite += findings.finite ? 0 : 1;
        ends += findings.end_overlap > k_overlap_allowed ? 1 : 0;
        if (!ends_well(findings))
            tally.note(fmt::format("        rest: seed {}: {} lost, overlap at the end {:.1e} sizes, rise {:.1e}; {}", seed,
                                   findings.lost, findings.end_overlap, findings.rise, scene.label));
    }
    const std::string what = fmt::format("rest: {} scenes from seed {}", job.count, job.seed);
    tally.result(not_finite == 0, fmt::format("{}: {} with a number that is none", what, not_finite));
    tally.result(lost == 0, fmt::format("{}: {} that lost a body", what, lost));
    tally.result(rise <= k_rise_allowed, fmt::format("{}: energy never rises, at most by {:.1e} of all", what, rise));
    tally.result(ends == 0, fmt::format("{}: {} that end with overlap beyond a hundredth of the smaller size, at most {:.1e}",
                                        what, ends, end_overlap));
    tally.note(fmt::format("        rest: deepest overlap at any step {:.1e} sizes", overlap));
}

} // namespace flying::stress
