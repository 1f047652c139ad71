#include "stress.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scene/generate.hpp"
#include "world/world.hpp"

namespace flying::stress {

void run_collapse(const Job& job, Tally& tally)
{
    // At e = 0.1 discs that meet hardly part: more and more impacts come within no time, and are handed over
    constexpr double k_until = 100.0; // [s], from one diameter a second
    constexpr int k_blocks = 100;
    GenerateOptions options;
    options.count = static_cast<int>(std::clamp(job.count, 10L, 1'000'000L));
    options.packing = 0.3;
    options.restitution = 0.1;
    options.friction = 0.0;
    options.rms_speed = 1.0;
    options.seed = job.seed;
    const Expected<Scene> scene = generate("gas", options);
    Expected<World> made = scene ? World::make(scene.value(), {}) : Expected<World>(scene.faults());
    if (!made) {
        tally.result(false, "collapse: no gas for these options");
        return;
    }
    World world = std::move(made).value();
    Report report = world.report();
    const double start = report.energy.total();
    double rise = 0.0;
    for (int k = 1; k <= k_blocks; ++k) {
        const auto failure = world.advance(k * (k_until / k_blocks));
        if (failure) {
            tally.result(false, "collapse: " + failure->message);
            return;
        }
        const double before = report.energy.total();
        report = world.report();
        rise = std::max(rise, (report.energy.total() - before) / start);
        tally.progress(fmt::format("collapse: {} discs, {:.0f} s of {:.0f}, {} hand-overs", *options.count, report.time,
                                   k_until, report.handovers.size()));
    }
    const double accounted = report.ledger.impacts + report.ledger.steps + report.ledger.handovers;
    const double lost = std::abs(report.energy.total() - start - accounted) / start;
    tally.result(true, fmt::format("collapse: {} discs at e = 0.1 go on for {:.0f} s: {} impacts, {} hand-overs, {:.2e} of the energy is left",
                                   *options.count, k_until, report.collisions, report.handovers.size(),
                                   report.energy.total() / start));
    tally.result(rise <= 1e-12 && lost <= 1e-11,
                 fmt::format("collapse: energy never rises (at most by {:.1e}), and all but {:.1e} of it is accounted for", rise, lost));
    // Clusters of more than four hundred are swept, and what a sweep leaves of an overlap goes within the next steps
    const double overlap = report.max_overlap / bounding_radius(world.shape(0));
    tally.result(overlap <= 0.01, fmt::format("collapse: no overlap beyond {:.1e} radii (a hundredth allowed)", overlap));
}

} // namespace flying::stress
