#pragma once

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "support/bodies.hpp"
#include "world/world.hpp"

/// Worlds that tests of several folders make alike.
namespace flying::testing {

/// The scene's world; its faults are told, and the test ends, where it has any.
inline World world_of(const Scene& scene, EngineChoice engine = EngineChoice::automatic,
                      const std::vector<std::string>& without = {})
{
    WorldOptions options;
    options.engine = engine;
    options.without = without;
    Expected<World> world = World::make(scene, options);
    if (!world) {
        for (const Fault& fault : world.faults()) MESSAGE(fault.place << ": " << fault.found << ", " << fault.expected);
    }
    REQUIRE(world.has_value());
    return std::move(world).value();
}

/// The same, where it is moved by steps, by those of so many seconds.
inline World with_step(const Scene& scene, double step)
{
    WorldOptions options;
    options.step = step;
    Expected<World> world = World::make(scene, options);
    REQUIRE(world.has_value());
    return std::move(world).value();
}

/// The same, moved by exact events alone.
inline World events_of(const Scene& scene, const std::vector<std::string>& without = {})
{
    return world_of(scene, EngineChoice::events, without);
}

inline void run(World& world, double until)
{
    const auto failure = world.advance(until);
    INFO((failure ? failure->message : std::string()));
    REQUIRE_FALSE(failure.has_value());
}

} // namespace flying::testing
