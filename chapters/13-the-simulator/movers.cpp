#include <cstdio>
#include <string>
#include <vector>

#include "runs.hpp"

using namespace flying;


int main()
{
    World world = start(rain(24, 5));
    std::vector<Report> reports;
    std::printf("%7s %8s %8s %8s %9s %8s\n", "t", "events", "rest", "asleep", "impacts",
                "steps");
    for (const double t : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 12.0}) {
        go(world, t);
        const Shares shares = shares_of(world);
        reports.push_back(world.report());
        long long steps = 0;
        for (const StageCost& stage : reports.back().stages) {
            if (stage.name == "move") steps = stage.count;
        }
        std::printf("%5.1f s %8d %8d %8d %9lld %8lld\n", t, shares.events, shares.rest,
                    shares.asleep, static_cast<long long>(reports.back().collisions),
                    steps);
    }

    std::printf("\n%7s %12s %12s %12s %12s\n", "t", "energy", "by impacts", "by steps",
                "hand-overs");
    for (const Report& report : reports) {
        std::printf("%5.1f s %10.3f J %10.3f J %10.3f J %10.0e J\n", report.time,
                    report.energy.total(), report.ledger.impacts, report.ledger.steps,
                    report.ledger.handovers);
    }
    std::printf("\nthe first hand-overs\n");
    int shown = 0;
    for (const Handover& handover : world.handovers()) {
        if (++shown > 6) break;
        const std::string why =
            handover.reason.substr(0, handover.reason.find(" at t ="));
        std::printf("%8.4f s  %zu to %s: %s\n", handover.time, handover.bodies.size(),
                    handover.to == Handover::To::rest ? "rest  " : "events", why.c_str());
    }
    std::printf("...\nof %zu\n", world.handovers().size());
}

