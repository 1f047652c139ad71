#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "motion/body.hpp"
#include "world/plan.hpp"

namespace flying {

/// Energy of all bodies that move.  [J]
struct Energy
{
    double kinetic = 0.0;
    double potential = 0.0; ///< in the uniform field, zero at the world's origin
    [[nodiscard]] double total() const { return kinetic + potential; }
};

/// One body as a report shows it.
struct BodyReport
{
    std::string name;
    BodyState state;
    double mass = 0.0;              ///< 0 for a static body [kg]
    double moment_of_inertia = 0.0; ///< 0 for a static body [kg m^2]
};

/// What one stage of the work cost.
struct StageCost
{
    std::string name;       ///< "predict", "impact", ...
    std::int64_t count = 0; ///< how often it was entered
    double seconds = 0.0;   ///< in all; 0 where the world was lent no stopwatch [s]
};

/// Bodies given from one integrator to the other.
struct Handover
{
    enum class To { rest, events };
    double time = 0.0;          ///< [s]; where bounces died away, the end of infinitely many of them
    std::vector<int> bodies;    ///< scene indices of those that changed hands, ascending
    std::string reason;         ///< one sentence
    double energy_change = 0.0; ///< by the hand-over itself [J]
    To to = To::rest;
    double energy_before = 0.0; ///< of these bodies, kinetic and potential [J]
    double energy_after = 0.0;  ///< [J]
    bool ends_bounces = false;  ///< bounces without number were jumped; `collisions` counts only those before
};

/// Where energy went since the start. The sum of all is what the total has changed.
struct EnergyLedger
{
    double impacts = 0.0;   ///< located impacts [J]
    double steps = 0.0;     ///< the resting integrator's steps [J]
    double handovers = 0.0; ///< hand-overs, and blows to bodies that lay [J]
};

/// How the steps of the resting integrator were made, since the world was made or resumed: how islands were solved, and
/// how often something other than forces of contact changed what their bodies do.
struct RestAccount
{
    std::int64_t islands = 0;    ///< in all steps, and in parts of them
    std::int64_t solved = 0;     ///< searches for impulses that ended at rounding, those that had nothing to change included
    std::int64_t swept = 0;      ///< that ended with what sweeps could do: the island was too large to be solved whole
    std::int64_t unsolved = 0;   ///< of which no solution was found: the best impulses that were met have acted
    std::int64_t parts = 0;      ///< steps that were made in parts, since they ended early
    std::int64_t projected = 0;  ///< islands whose overlap was taken off by moving bodies apart
    std::int64_t limited = 0;    ///< islands slowed down, so that they have no more energy than before
    double energy_limited = 0.0; ///< the energy that this took [J]
    double elastic_ended = 0.0;  ///< lost at e = 1 without friction: approaches that rounds of impacts did not end [J]
    double elastic_braked = 0.0; ///< the same, by gaps that were braked to close as the step ends [J]
};

/// The world at one moment, and what it took to get there.
struct Report
{
    double time = 0.0;               ///< [s]
    std::string engine;              ///< "events", "rest", or "events and rest"
    std::int64_t events = 0;         ///< all handled
    std::int64_t collisions = 0;     ///< impulses between bodies, walls included
    std::vector<Handover> handovers; ///< in the order in which they came
    Energy energy;
    double initial_total = 0.0; ///< [J]
    EnergyLedger ledger;
    Vec2 momentum = Vec2::Zero(); ///< [kg m/s]
    double angular_momentum = 0.0; ///< about the world's origin [kg m^2/s]
    double max_overlap = 0.0; ///< deepest ever met, at events and reports; 0 where nothing overlapped [m]
    std::uint64_t hash = 0;   ///< of the log of events and the final state
    Plan plan;
    std::vector<StageCost> stages;
    std::vector<std::string> warnings; ///< sentences: what the run did that the scene doesn't say
    std::optional<RestAccount> rest; ///< where anything ever leant on anything
    std::vector<BodyReport> bodies; ///< in the scene's order
};

} // namespace flying
