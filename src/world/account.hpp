#pragma once

#include <cstdint>
#include <vector>

#include "collide/separation.hpp"
#include "events/event_engine.hpp"
#include "rest/rest_engine.hpp"
#include "world/hybrid.hpp"
#include "world/report.hpp"
#include "world/world.hpp"

// What a report says, worked out from the engine's bodies and counts.
namespace flying {

/// One body at one moment, by whichever integrator it moves.
struct BodyView
{
    BodyState state;
    Inertia inertia;
    const Shape* shape = nullptr;
    bool is_static = false;
};

/// Sums over the scene's bodies at one moment.
struct Account
{
    Energy energy;
    Vec2 momentum = Vec2::Zero();  ///< [kg m/s]
    double angular_momentum = 0.0; ///< about the world's origin [kg m^2/s]
    std::vector<BodyReport> bodies;
};

/// bodies  the scene's, in its order, then the walls
[[nodiscard]] Account take_account(const std::vector<BodyView>& bodies, const Scene& scene);

/// Depth of the deepest overlap of any two bodies, two static ones aside; 0 where there is none.  [m]
/// shapes  of the same bodies
[[nodiscard]] double deepest_overlap(const std::vector<BodyView>& bodies, const std::vector<CollisionShape>& shapes);

/// Fingerprint of all that happened and of where it led.
[[nodiscard]] std::uint64_t final_hash(std::uint64_t log_hash, const std::vector<BodyReport>& bodies);

/// The plan, with the work that its skips saved.
[[nodiscard]] Plan plan_with_savings(Plan plan, const EventCounts& counts, const RestEngine* rest);

[[nodiscard]] std::vector<StageCost> stage_costs(const EventCounts& counts, const EventSeconds& seconds);
[[nodiscard]] std::vector<StageCost> stage_costs(const RestCounts& counts, const RestSeconds& seconds);

[[nodiscard]] RestAccount rest_account(const RestCounts& counts, const SolveCounts& solves);

/// What a run did that its scene doesn't say, a sentence each.
/// energy  of the run, against which losses are judged [J]
[[nodiscard]] std::vector<std::string> warnings_of(const RestAccount& rest, double energy);

/// A hand-over in the words of the scene.
[[nodiscard]] Handover describe(const Hybrid::Change& change, const Scene& scene);

/// A failure of the engine in the words of the scene.
[[nodiscard]] RunFailure describe(const EventFailure& failure, const Scene& scene);

} // namespace flying
