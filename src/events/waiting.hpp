#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "events/event_queue.hpp"
#include "math/roots.hpp"

namespace flying {

/// What is foreseen of a body beyond its first event. Only that one goes into the queue; the others wait here, in one
/// line of the fast memory, until it is over or overtaken. Most of them never come up: the body is struck before.
struct alignas(64) Waiting
{
    /// An event of the body, without what the body itself knows.
    struct Entry
    {
        double time = k_never;
        int with = -1; ///< the partner's id, or the side of a cell as events write it
        std::uint32_t stamp = 0;
    };
    static constexpr int k_most = 3;

    double called = k_never; ///< time of the event in the queue; infinite where there is none [s]
    std::array<Entry, k_most> entries;
    std::array<Event::Kind, k_most> kinds = {};
    std::uint8_t count = 0; ///< of those that wait

    /// Let an event wait; false where there is no room.
    [[nodiscard]] bool keep(const Event& event)
    {
        if (count == k_most) return false;
        entries[count] = {event.time, event.owner == Event::Owner::b ? event.a : event.b, event.stamp};
        kinds[count++] = event.kind;
        return true;
    }

    /// One that waits.  id  the body's
    [[nodiscard]] Event event(int k, int id) const
    {
        const Entry& entry = entries[k];
        const bool is_first = entry.with < 0 || id < entry.with;
        return {entry.time,
                is_first ? id : entry.with,
                is_first ? entry.with : id,
                entry.stamp,
                kinds[k],
                is_first ? Event::Owner::a : Event::Owner::b};
    }
    /// The one that happens first, of at least one.
    [[nodiscard]] int first(int id) const
    {
        int first = 0;
        for (int k = 1; k < count; ++k) {
            if (entries[k].time > entries[first].time) continue;
            if (entries[k].time < entries[first].time || happens_before(event(k, id), event(first, id))) first = k;
        }
        return first;
    }
    /// One of them happens no later than that.  [s]
    [[nodiscard]] bool has_by(double time) const
    {
        return std::any_of(entries.begin(), entries.begin() + count,
                           [&](const Entry& entry) { return entry.time <= time; });
    }
    void drop(int k)
    {
        entries[k] = entries[--count];
        kinds[k] = kinds[count];
    }
};

} // namespace flying
