#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/read.hpp"
#include "world/world.hpp"

// Runs of the course's scenes with some work left out, and what they counted.
namespace flying {


/// A run, and what a plan must not change.
struct Run
{
    Report report;
    std::vector<std::uint64_t> hashes; ///< of the log, after every impact
};



/// without  skips that are turned off; until  [s]
inline Run run(const Scene& scene, double until,
               const std::vector<std::string>& without = {})
{
    WorldOptions options;
    options.without = without;
    options.engine = EngineChoice::events;
    Expected<World> made = World::make(scene, options);
    World world = std::move(made).value();
    Run run;
    run.hashes = {world.log_hash()};
    while (world.time() < until) {
        // One event at a time; most are no impacts, and leave the log as it is
        if (world.advance(until, 1)) break;
        if (world.log_hash() != run.hashes.back()) run.hashes.push_back(world.log_hash());
    }
    run.report = world.report();
    return run;
}



/// Names of all skips, to turn them off at once. One stays: `cells` is the choice of *not*
/// keeping cells for few bodies, and without it they would be looked up in a grid.
inline std::vector<std::string> all_skips()
{
    std::vector<std::string> names = skip_names();
    std::erase(names, "cells");
    return names;
}



/// Pairs foreseen, and pairs of turning bodies looked at again.
inline std::int64_t pairs_looked_at(const Report& report)
{
    std::int64_t sum = 0;
    for (const StageCost& stage : report.stages) {
        if (stage.name == "predict" || stage.name == "look again") sum += stage.count;
    }
    return sum;
}



/// A scene of the course, by its name.
inline Scene scene_of_course(const std::string& folder, const std::string& name)
{
    Expected<Scene> scene = read_scene_file(folder + "/" + name + ".toml");
    return std::move(scene).value();
}


} // namespace flying
