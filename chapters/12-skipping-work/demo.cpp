#include <cstdio>
#include <string>

#include "runs.hpp"

using namespace flying;

namespace {

struct Named
{
    const char* name;
    double until; ///< [s]
};
constexpr Named k_scenes[] = {{"flying-balls", 2.0},
                              {"gas-discs-1000", 0.5},
                              {"gas-polygons-200", 0.5},
                              {"gas-dumbbells-100", 0.5},
                              {"original-polygons", 4.0},
                              {"pi-billiard", 4.0},
                              {"orbits", 2.0}};


/// The plan of one scene, in full.
void print_plan(const char* name)
{
    std::printf("%s\n", name);
    for (const Skip& skip : make_plan(scene_of_course(FLYING_SCENES, name)).skips) {
        std::printf("  %-8s %s\n    %s\n", fate_of(skip), skip.name.c_str(),
                    skip.reason.c_str());
    }
}



/// Each scene with its plan, and with all skips off: pairs looked at, and whether any bit
/// differs.
void print_savings()
{
    std::printf("\n%-19s %12s %12s %9s   %s\n", "pairs looked at", "without plan",
                "with plan", "impacts", "bits");
    for (const auto& [name, until] : k_scenes) {
        const Scene scene = scene_of_course(FLYING_SCENES, name);
        const Run with = run(scene, until);
        const Run without = run(scene, until, all_skips());
        const bool same = with.hashes == without.hashes;
        std::printf("%-19s %12lld %12lld %9zu   %s\n", name,
                    static_cast<long long>(pairs_looked_at(without.report)),
                    static_cast<long long>(pairs_looked_at(with.report)),
                    with.hashes.size() - 1,
                    same && with.report.hash == without.report.hash ? "same" : "DIFFERENT");
    }
}



/// What each skip of each scene counted, for those that count something.
void print_each()
{
    std::printf("\n%-19s", "saved by");
    for (const Skip& skip : make_plan(Scene{}).skips) {
        if (!skip.saved_unit.empty()) std::printf(" %13s", skip.name.c_str());
    }
    std::printf("\n");
    for (const auto& [name, until] : k_scenes) {
        std::printf("%-19s", name);
        const Report report = run(scene_of_course(FLYING_SCENES, name), until).report;
        for (const Skip& skip : report.plan.skips) {
            if (skip.saved_unit.empty()) continue;
            if (skip.active) std::printf(" %13lld", static_cast<long long>(skip.saved));
            else std::printf(" %13s", "-");
        }
        std::printf("\n");
    }
}


} // namespace


int main()
{
    print_plan("original-polygons");
    print_plan("gas-discs-1000");
    print_savings();
    print_each();
}

