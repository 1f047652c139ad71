#pragma once

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/bodies.hpp"
#include "support/overlap.hpp"
#include "world/world.hpp"

/// The rows of the stress table, each an attempt to break the simulator. ./course stress table runs them.
namespace flying::stress {

/// How far an attempt got.
struct Reached
{
    double value = 0.0;   ///< in the unit of its row
    std::string amount;   ///< how much was tried
    std::string remark;   ///< what else was seen; may be empty
    bool is_whole = true; ///< all that the row asks for was tried
};

/// What a long attempt may take now, and where it keeps how far it is.
struct Share
{
    double seconds = 0.0; ///< of computing, for this call [s]
    std::string folder;   ///< there, and to be written to
};

/// One row. A whole number of `reached` counts bodies, scenes or pairs.
struct Trial
{
    int number = 0; ///< of the table; rows of one number belong together
    const char* name = "";
    const char* measure = ""; ///< what `value` is, with its unit
    double bound = 0.0;
    bool at_least = false;      ///< the value should be at least the bound; else at most
    const char* elsewhere = ""; ///< the best that is known of other engines
    Reached (*run)(const Share&) = nullptr;
};

/// In the order of their numbers within each.
[[nodiscard]] std::span<const Trial> trials_of_flight();
[[nodiscard]] std::span<const Trial> trials_of_rest();
[[nodiscard]] std::span<const Trial> trials_of_crowds(); ///< many bodies: a gas that collapses, heaps, towers, lattices
[[nodiscard]] std::span<const Trial> trials_of_corners(); ///< seams, steps, notches, knife edges
[[nodiscard]] std::span<const Trial> trials_of_links();   ///< bodies that hold each other: chains and rings
[[nodiscard]] std::span<const Trial> trials_of_doors();   ///< what a scene may say, and what is refused
[[nodiscard]] std::span<const Trial> trials_of_bits(); ///< the same result whatever is asked, saved, renamed, compiled
[[nodiscard]] std::span<const Trial> trials_of_length(); ///< those that take hours, a share at a time

// ---- What several of them make ------------------------------------------------------------------------------------

using testing::deepest_overlap;
using testing::disc;
using testing::rectangle;
using testing::still;

inline constexpr double k_gravity = 9.81; ///< [m/s^2]

/// A floor that reaches far; gravity leans by `tilt` towards positive x.
inline Scene over_floor(double restitution, double friction, double tilt = 0.0)
{
    Scene scene;
    scene.world.field = UniformField{{k_gravity * std::sin(tilt), -k_gravity * std::cos(tilt)}};
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    scene.world.box = BoxDef{{-5000.0, 0.0}, {5000.0, 5000.0}};
    return scene;
}

/// The scene's world. Throws where it is refused: these scenes are meant to be valid.
inline World world_of(const Scene& scene, const WorldOptions& options = {})
{
    Expected<World> world = World::make(scene, options);
    if (!world) {
        const Fault& fault = world.faults().front();
        throw std::runtime_error("refused: " + fault.place + ": " + fault.found);
    }
    return std::move(world).value();
}

inline World events_of(const Scene& scene)
{
    WorldOptions options;
    options.engine = EngineChoice::events;
    return world_of(scene, options);
}

/// Throws where the run can't go on.
inline void run_to(World& world, double time)
{
    if (const auto failure = world.advance(time)) throw std::runtime_error(failure->message);
}

} // namespace flying::stress
