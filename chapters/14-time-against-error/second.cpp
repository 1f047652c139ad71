// What the second kept run says: Siconos beside the others where contacts last, and kernels in floats beside doubles.
// Nothing is measured here: every line comes from second.jsonl.

#include <algorithm>
#include <cstdio>

#include "record.hpp"

using namespace flying::work;

namespace {

/// The points of a curve in a scene; an empty list where the run has none.
std::vector<Point> curve(const Records& records, const std::string& scene, const std::string& engine,
                         std::size_t measure = 0)
{
    const DiagramRecord* diagram = records.diagram(scene);
    return diagram ? points_of(*diagram, engine, measure) : std::vector<Point>{};
}

double least_error(const std::vector<Point>& points)
{
    double least = HUGE_VAL;
    for (const Point& point : points) least = std::min(least, point.error);
    return least;
}

/// Median over the settings that both curves have: how many times as long the first takes.
double time_ratio(const std::vector<Point>& a, const std::vector<Point>& b)
{
    std::vector<double> ratios;
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) ratios.push_back(a[k].seconds / b[k].seconds);
    return spread_of(ratios).median;
}

} // namespace

int main()
{
    const auto read = read_kept_run(FLYING_SECOND);
    if (!read) return 1;
    const Records& records = *read;
    std::printf("Run '%s' of %s, %d repeats\n", records.run.name.c_str(), records.run.date.c_str(),
                records.run.repeats);
    print_with_what(records.run);

    for (const DiagramRecord& diagram : records.diagrams) {
        std::printf("\n%s: %s\n", diagram.name.c_str(), diagram.measures.front().c_str());
        for (const CurveRecord& one : diagram.curves) {
            if (one.points.empty()) {
                std::printf("  %-25s %s\n", one.engine.c_str(), one.why_not.c_str());
                continue;
            }
            const std::vector<Point> points = points_of(diagram, one.engine);
            const Point& first = points.front();
            std::printf("  %-25s %8.1e in %7.1e s, %8.1e in %7.1e s\n", one.engine.c_str(), first.error, first.seconds,
                        points.back().error, points.back().seconds);
        }
    }

    std::printf("\n");
    for (const char* scene : {"incline", "rolling"}) {
        std::printf("%s by sweeps = %.1e m\n", scene, least_error(curve(records, scene, "Siconos, sweeps")));
        std::printf("%s over ours = %.2g\n", scene,
                    time_ratio(curve(records, scene, "Siconos, sweeps"), curve(records, scene, "flying")));
    }
    std::printf("incline by pivots = %.1e m\n", least_error(curve(records, "incline", "Siconos, Lemke")));
    std::printf("mass ratio by pivots = %.1e m\n", least_error(curve(records, "mass-ratio", "Siconos, Lemke")));
    std::printf("rocking by sweeps = %.1e m\n", least_error(curve(records, "rocking-block", "Siconos, sweeps")));
    for (const char* kernel : {"orbit", "gas", "stack"}) {
        const std::string scene = std::string("numbers-") + kernel;
        std::printf("%s in doubles = %.1e\n", kernel, least_error(curve(records, scene, "doubles")));
        std::printf("%s in floats = %.1e\n", kernel, least_error(curve(records, scene, "floats")));
        std::printf("%s floats over doubles = %.2f\n", kernel,
                    time_ratio(curve(records, scene, "floats"), curve(records, scene, "doubles")));
    }
    return 0;
}
