#pragma once

// The commands of the program, their options, and its exit statuses.

#include <optional>
#include <string>
#include <vector>

#include "scene/generate.hpp"

namespace flying {

/// Exit status of the program.
namespace status {
inline constexpr int k_done = 0;
inline constexpr int k_failed = 1; ///< the run, or writing its results
inline constexpr int k_usage = 2;  ///< bad usage or bad scene; nothing is written
} // namespace status

/// What `flying simulate` was asked for.
struct SimulateOptions
{
    std::string scene;
    std::optional<double> until; ///< in place of the scene's [s]
    std::optional<std::string> engine; ///< auto, events or rest; auto where nothing is said
    std::optional<double> step;  ///< of the resting integrator [s]
    std::vector<std::string> without;
    std::string report; ///< this and the next: where to write; empty for nowhere
    std::string trace;
    std::optional<double> every; ///< between lines of the trace [s]
    std::string picture;
    std::string video;
    std::string save;   ///< where to write what it takes to go on later; empty for nowhere
    std::string resume; ///< such a file, to go on from; empty for the start
    bool explain = false;
    bool stats = false;
    bool quiet = false;
};

/// What `flying window` was asked for.
struct WatchOptions
{
    std::string scene; ///< empty for the first scene of the course
    std::string size;  ///< such as 1280x800; empty for that
    std::string state; ///< where F8 writes what the window knows
    std::string face;  ///< a PNG for the balls; empty for none
    bool is_bare = false; ///< without controls at the side
    bool is_dark = false;
    bool is_paused = false;
};

/// Each command does all of its work, prints what it has to say, and returns the exit status.
[[nodiscard]] int simulate(const SimulateOptions& options);
[[nodiscard]] int check(const std::string& scene_path);
[[nodiscard]] int explain(const std::string& scene_path, const std::vector<std::string>& without);
/// Faults where the build has no window, or the machine no display.
[[nodiscard]] int watch(const WatchOptions& options);

/// command  the command line as typed, for the first line of the scene
[[nodiscard]] int generate_to_stdout(const std::string& kind, const GenerateOptions& options,
                                     const std::string& command);

} // namespace flying
