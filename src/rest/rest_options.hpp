#pragma once

#include <cstdint>
#include <optional>

#include "motion/field.hpp"

namespace flying {

/// How the resting engine moves bodies: the length of its steps, and how much work goes into the forces. The defaults
/// are those that `World` runs with.
struct RestOptions
{
    double step = 1.0 / 60.0; ///< > 0 [s]
    bool warm_starts = true;  ///< impulses are sought from those of the step before
    bool sleeps = true;       ///< islands that a step leaves as they are, to the bit, are left out of the next
    int most_solved = 400;    ///< bodies in the largest island that is solved whole while it hardly moves
    int sweeps = 8;           ///< over islands that aren't solved
    int most_sweeps = 64;     ///< over those that have more to change, as where a pile lands
    std::optional<CentralField> centre = {}; ///< that pulls all bodies, in place of accelerations of their own
    double (*seconds)() = nullptr;           ///< a clock, lent to measure the stages; null to measure nothing [s]
};

/// Work done so far.
struct RestCounts
{
    std::int64_t steps = 0;
    std::int64_t looks = 0;      ///< searches for pairs
    std::int64_t boxes = 0;      ///< sorted in these
    std::int64_t pairs = 0;      ///< of bodies near each other, one of which was awake: in all steps
    std::int64_t manifolds = 0;  ///< pairs whose points were sought
    std::int64_t points = 0;     ///< points solved for
    std::int64_t islands = 0;    ///< solved for
    std::int64_t impacts = 0;    ///< points at which an approach was ended
    std::int64_t asleep = 0;     ///< bodies left out, over all steps
    std::int64_t parts = 0;      ///< steps, or parts of steps, of islands that ended early
    std::int64_t projected = 0;  ///< islands whose overlap was taken off
    std::int64_t limited = 0;    ///< islands slowed down, so that they have no more energy than before
    double energy_limited = 0.0; ///< the energy that this took [J]
    double elastic_ended = 0.0;  ///< lost at e = 1 without friction: approaches that rounds of impacts did not end [J]
    double elastic_braked = 0.0; ///< the same, by gaps that were braked to close as the step ends [J]
};

/// Seconds spent, where a clock was lent.
struct RestSeconds
{
    double pairs = 0.0;
    double collide = 0.0;
    double solve = 0.0;
    double move = 0.0;
};

} // namespace flying
