#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "events/body_rows.hpp"
#include "events/meeting.hpp"

namespace flying {

// Where impacts would follow each other without end: what tells that two bodies lean on each other from here on. Bodies
// are named by their rows, a and b as in the meeting.

/// The pair approaches no faster than what presses it together brings about within the tolerance of touching: its hops
/// can't be told from contact that lasts, however fast it slides or rolls. Before the impact.
[[nodiscard]] bool is_creeping(const BodyRows& bodies, int a, int b, const MeetingPoints& meeting);

/// How long two bodies have flown since their last impacts; for ever where they are fixed.
struct TimeSinceImpact
{
    double a = 0.0; ///< [s]
    double b = 0.0; ///< [s]

    /// Since the last impact of either.  [s]
    [[nodiscard]] double last() const { return std::min(a, b); }
};

/// time  of the impact, to which neither has been brought yet [s]
[[nodiscard]] TimeSinceImpact time_since_impact(const BodyRows& bodies, int a, int b, double time);

/// The pair has so little room that it comes back again and again, however fast it is: both have moved by next to
/// nothing since their last impacts. A body that hops on what is fixed isn't cramped, however low it hops: only the
/// field brings it back. Before the impact.
[[nodiscard]] bool is_cramped(const BodyRows& bodies, int a, int b, const MeetingPoints& meeting,
                              const TimeSinceImpact& since);

/// Impacts in a row without room that end by themselves: a light body between a heavy one and a wall bounces pi times
/// the root of their masses' ratio before the heavy one has turned round (Galperin 2003), however near it comes. For
/// the heaviest and the lightest of all that move.
[[nodiscard]] int bounces_by_masses(const BodyRows& bodies);

/// After an impact that takes speed away, two bodies part at some point by so little that the field, which presses them
/// together there, ends that within the tolerance of touching. Impact would follow impact with no time between them:
/// from here on the two lean on each other. Elastic and smooth ones never do.
[[nodiscard]] bool stays(const BodyRows& bodies, int a, int b, const MeetingPoints& meeting);

/// Bounces of one body on one flat thing, undisturbed.
struct Bounces
{
    int on = -1; ///< -1 where the last impact was none of them
    Vec2 normal = Vec2::Zero();
    double end = 0.0; ///< [s]
};

/// When bounces end that have just shrunk to a touch; nothing where they haven't. After the impact.
///
/// A disc that leaves something flat at speed v, pressed on by g, is back after 2 v/g, and leaves with e v: all hops
/// together take 2 v / (g (1 - e)). Neither its spin nor its sliding knows of the normal motion. The end is found at
/// the first bounce, where v has all its digits, and kept as long as nothing else is met.
///
/// time     of the impact [s]
/// bounces  of each body, by id: those of the two are noted, or forgotten
[[nodiscard]] std::optional<double> end_of_bounces(const BodyRows& bodies, int a, int b, const MeetingPoints& meeting,
                                                   double time, std::vector<Bounces>& bounces);

} // namespace flying
