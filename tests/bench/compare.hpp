#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenes.hpp"
#include "simulators.hpp"

namespace flying::bench {

/// What one engine did with one scene.
struct Showing
{
    EngineChoice engine;
    std::vector<double> seconds;      ///< computing, of each repeat, without setting up [s]
    std::vector<double> wall_seconds; ///< of the same [s]
    double setup_seconds = 0.0;       ///< of the first: reading, checking, first predictions [s]
    double drift = 0.0;               ///< of the energy, relative
    double overlap = 0.0;             ///< deepest seen at the samples [m]
    std::optional<double> path_error; ///< median distance from the exact places after 1 s [m]
    long collisions = 0;              ///< where the engine counts them
    std::string failure;              ///< why it could not go on; empty where it could
    std::optional<double> stopped_at; ///< where a peer's run was given up: the moment it had come to [s]
};

struct Comparison
{
    std::string name;
    std::string aim;
    int bodies = 0;
    double until = 0.0;            ///< [s]
    double samples_hertz = 0.0;    ///< how often overlap was looked for [1/s]
    std::string exact_path;        ///< what the path error is measured against
    double exact_path_error = 0.0; ///< how well that is known itself [m]
    std::vector<Showing> showings;
};

/// Run one scene in all engines in turn, again and again.
/// hertz  the peers' steps a second [1/s]
/// most   a peer's run is given up after the step that takes it past so much computing [s]
/// tell   is told what is going on
[[nodiscard]] Comparison compare(const BenchCase& bench_case, double until, int repeats, double hertz, double most,
                                 const std::function<void(const std::string&)>& tell);

} // namespace flying::bench
