#include "scenes.hpp"

#include <cstdio>
#include <cstdlib>

namespace flying::bench {

GenerateOptions gas(int count, double packing, const std::string& shape, int min_sides, int max_sides)
{
    GenerateOptions options;
    options.seed = 20;
    options.count = count;
    options.packing = packing;
    options.rms_speed = 5.0;
    options.radius = Bounds{0.5, 0.5};
    options.shape = shape;
    if (shape == "polygon") {
        options.min_sides = min_sides;
        options.max_sides = max_sides;
    }
    return options;
}

const std::vector<BenchCase>& bench_cases()
{
    static const std::vector<BenchCase> cases = {
        {"discs-1000-p0.1", "gas", gas(1000, 0.1), 10.0, 10.0, true,
         "<= 0.25 of Chipmunk, drift <= 1e-13, error <= 1e-11"},
        {"discs-1000-p0.5", "gas", gas(1000, 0.5), 10.0, 10.0, true, "<= 1.0 of Chipmunk"},
        {"polygons-1000-p0.1", "gas", gas(1000, 0.1, "polygon"), 10.0, 10.0, true,
         "<= 1.0 of Chipmunk, drift <= 1e-12"},
        {"polygons-1000-p0.4", "gas", gas(1000, 0.4, "polygon"), 10.0, 2.0, true, "<= 2.0 of Chipmunk, drift <= 1e-12"},
        {"dumbbells-300-p0.2", "gas", gas(300, 0.2, "dumbbell"), 10.0, 2.0, true, "drift <= 1e-12, overlap 0"},
        {"discs-10000-p0.1", "gas", gas(10000, 0.1), 10.0, 2.0, true, "<= 0.2 of Chipmunk"},
        {"discs-10000-p0.5", "gas", gas(10000, 0.5), 10.0, 1.0, true, "<= 0.7 of Chipmunk"},
        {"discs-1000000-p0.3", "gas", gas(1000000, 0.3), 0.5, 0.0, false, ">= 1e6 collisions a second"},
    };
    return cases;
}

Scene scene_of(const std::string& kind, const GenerateOptions& options)
{
    Expected<Scene> made = generate(kind, options);
    if (made) return std::move(made).value();
    const Fault& fault = made.faults().front();
    std::fprintf(stderr, "%s: the generator found %s, expected %s\n", fault.place.c_str(), fault.found.c_str(),
                 fault.expected.c_str());
    std::exit(1);
}

} // namespace flying::bench
