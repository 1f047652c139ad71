#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "events/body_rows.hpp"
#include "events/event_queue.hpp"
#include "events/lasting_contact.hpp"
#include "events/meeting.hpp"
#include "events/static_surfaces.hpp"

namespace flying {

/// Two bodies at the moment of their impact.
struct Encounter
{
    Event impact;
    int a = 0; ///< rows
    int b = 0;
    TimeSinceImpact since; ///< of their last ones, before this
    bool moved = false;    ///< at least one of them did, since then
    MeetingPoints meeting;
    bool has_room = false; ///< between their impacts
    bool sinks = false;    ///< they have none, and one is behind a side of the other
    std::optional<double> bounces_end;
    bool stays = false;
};

/// Bring all bodies of a group of impacts to their moment, and find where they touch.
///
/// impacts  of one moment, that of the first
/// Returns the impact of a body that has turned through too large an angle, and stops there; else null.
[[nodiscard]] const Event* meet(BodyRows& bodies, const StaticSurfaces& surfaces, std::span<const Event> impacts,
                                std::span<Encounter> encounters);

/// Whether two bodies that meet have room between their impacts, and aren't held either. Before the impact.
/// shortest_bounce  between impacts that don't count as held [s]
[[nodiscard]] bool judge_room(const BodyRows& bodies, double shortest_bounce, Encounter& one);

/// What pushes made of the bodies of a group of impacts.
struct Push
{
    struct Motion
    {
        int row = 0;
        Vec2 velocity = Vec2::Zero(); ///< [m/s]
        double spin = 0.0;            ///< [rad/s]
    };
    std::vector<Motion> motions; ///< of each of the bodies, once
    std::int64_t impacts = 0;    ///< in which some point was pushed
    bool ended = true;           ///< nothing still approaches that should have been turned round
};

/// Pushes two bodies apart that meet; or all of a group, in one round: of those, what still approaches strikes again,
/// at the same moment.
/// push  is written anew; its memory is used again
void push_apart(const BodyRows& bodies, std::span<const Encounter> encounters, Push& push);

} // namespace flying
