#include <cstdio>
#include <string>

#include "runs.hpp"

using namespace flying;

namespace {

// [simulator.demo.scene]
/// A minute of a scene: what has happened every ten seconds, and what it cost.
void run_for_a_minute(const std::string& name)
{
    World world = start(scene_of_course(FLYING_SCENES, name));
    std::printf("%s\n", world.scene().title.c_str());
    std::printf("%6s %9s %12s %12s %14s %13s\n", "t", "impacts", "kinetic", "potential",
                "energy gained", "overlap");
    Report report;
    for (int t = 0; t <= 60; t += 10) {
        go(world, t);
        report = world.report();
        const Energy& energy = report.energy;
        std::printf("%4d s %9lld %10.1f J %10.1f J %12.0e J %11.0e m\n", t,
                    static_cast<long long>(report.collisions), energy.kinetic,
                    energy.potential, energy.total() - report.initial_total,
                    report.max_overlap);
    }
    std::printf("hash   %016llx\n\n", static_cast<unsigned long long>(report.hash));
}
// [simulator.demo.scene]

} // namespace

// [simulator.demo]
/// name  of one more scene of chapters/scenes, without its ending
int main(int argc, char** argv)
{
    run_for_a_minute("original-polygons");
    run_for_a_minute("original-polygons-gravity");
    if (argc > 1) run_for_a_minute(argv[1]);
}
// [simulator.demo]
