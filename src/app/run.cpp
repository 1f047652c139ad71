#include "app/run.hpp"

#include <algorithm>

#include "app/clock.hpp"
#include "files/interrupt.hpp"
#include "world/event_share.hpp"

namespace flying {

namespace {

/// Nothing where the world got there.
std::optional<RunEnd> advance_to(World& world, double time, Progress& progress, double& engine_seconds)
{
    EventShare share;
    while (true) {
        const long before = world.events();
        const double started = seconds_now();
        const std::optional<RunFailure> failure = world.advance(time, share.size());
        const double seconds = seconds_now() - started;
        engine_seconds += seconds;
        if (failure) return RunEnd(*failure);
        if (const int signal = interrupted()) return RunEnd(Interrupted{signal});
        progress.update(world.time(), world.events());
        // More events may wait at the very time at which the clock stands
        if (world.time() >= time && world.events() - before < share.size()) return std::nullopt;
        share.took(seconds);
    }
}

double next_look(const Recorders& recorders)
{
    double next = k_never;
    if (recorders.trace) next = std::min(next, recorders.trace->next());
    if (recorders.video) next = std::min(next, recorders.video->next());
    if (recorders.trails) next = std::min(next, recorders.trails->next());
    return next;
}

std::optional<Fault> look(const World& world, double time, Recorders& recorders)
{
    if (recorders.trails && recorders.trails->next() <= time) recorders.trails->look(world);
    if (recorders.trace && recorders.trace->next() <= time) {
        if (std::optional<Fault> fault = recorders.trace->look(world)) return fault;
    }
    if (recorders.video && recorders.video->next() <= time) return recorders.video->look(world);
    return std::nullopt;
}

} // namespace

RunResult run(World& world, double end, Recorders& recorders, Progress& progress)
{
    RunResult result;
    for (double next = next_look(recorders); next <= end; next = next_look(recorders)) {
        if (auto stopped = advance_to(world, next, progress, result.engine_seconds)) {
            result.end = *stopped;
            return result;
        }
        if (auto fault = look(world, next, recorders)) {
            result.end = *fault;
            return result;
        }
    }
    if (auto stopped = advance_to(world, end, progress, result.engine_seconds)) result.end = *stopped;
    return result;
}

} // namespace flying
