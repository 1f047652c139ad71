#include <cstdio>

#include "runs.hpp"

using namespace flying;

// [simulator.movers]
int main()
{
    World world = start(rain(24, 5));
    std::printf("%7s %7s %7s %7s %9s %7s %12s %12s %12s %12s\n", "t", "events", "rest",
                "asleep", "impacts", "steps", "energy", "by impacts", "by steps",
                "hand-overs");
    for (const double t : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0}) {
        go(world, t);
        const Shares shares = shares_of(world);
        const Report report = world.report();
        long long steps = 0;
        for (const StageCost& stage : report.stages) {
            if (stage.name == "move") steps = stage.count;
        }
        std::printf(
            "%5.1f s %7d %7d %7d %9lld %7lld %10.3f J %10.3f J %10.3f J %10.0e J\n", t,
            shares.events, shares.rest, shares.asleep,
            static_cast<long long>(report.collisions), steps, report.energy.total(),
            report.ledger.impacts, report.ledger.steps, report.ledger.handovers);
    }
    std::printf("\nthe first hand-overs\n");
    int shown = 0;
    for (const Handover& handover : world.handovers()) {
        if (++shown > 6) break;
        std::printf("%8.4f s  %2zu to %s: %s\n", handover.time, handover.bodies.size(),
                    handover.to == Handover::To::rest ? "rest  " : "events",
                    handover.reason.c_str());
    }
    std::printf("...\nof %zu\n", world.handovers().size());
}
// [simulator.movers]
