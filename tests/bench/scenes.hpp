#pragma once

#include <string>
#include <vector>

#include "scene/generate.hpp"
#include "world/scene.hpp"

namespace flying::bench {

/// A scene to measure.
struct BenchCase
{
    std::string name; ///< as `--scene` takes it
    std::string kind; ///< of the generator
    GenerateOptions options;
    double until = 10.0;       ///< simulated in the long set [s]
    double short_until = 10.0; ///< simulated in the short set; 0: not in it [s]
    bool has_peers = true;
    std::string aim; ///< what it is to reach
};

/// The table of scenes.
[[nodiscard]] const std::vector<BenchCase>& bench_cases();

/// A gas of equal bodies in a box, rms speed 5 m/s, circles of 0.5 m.
/// shape  disc, dumbbell, or polygon with min_sides ... max_sides sides
[[nodiscard]] GenerateOptions gas(int count, double packing, const std::string& shape = "disc", int min_sides = 3,
                                  int max_sides = 6);

/// The scene; ends the program with a message where the generator refuses.
[[nodiscard]] Scene scene_of(const std::string& kind, const GenerateOptions& options);

} // namespace flying::bench
