#pragma once

#include <optional>
#include <variant>

#include "app/progress.hpp"
#include "app/recorders.hpp"
#include "world/world.hpp"

namespace flying {

/// What is recorded while a world runs; each recorder may be absent.
struct Recorders
{
    std::optional<TraceRecorder> trace;
    std::optional<VideoRecorder> video;
    std::optional<TrailRecorder> trails;
};

/// Asked to stop, by a signal.
struct Interrupted
{
    int signal = 0;
};

/// How a run ended: at its end; by a failure of the world; by one of an output; by a signal.
struct Finished
{
};
using RunEnd = std::variant<Finished, RunFailure, Fault, Interrupted>;

struct RunResult
{
    RunEnd end;
    double engine_seconds = 0.0; ///< spent in the world itself, looking aside [s]
};

/// Let the world run to `end`, stopping at every moment that a recorder wants to look at.
/// end  not before the world's clock  [s]
[[nodiscard]] RunResult run(World& world, double end, Recorders& recorders, Progress& progress);

} // namespace flying
