#pragma once

#include <vector>

#include "events/body_rows.hpp"
#include "events/event_queue.hpp"
#include "events/static_surfaces.hpp"

namespace flying {

/// The impacts of one moment, while they are handled: those that share a body that moves are one group, and push
/// together.
class ImpactsAtOnce
{
public:
    [[nodiscard]] bool is_empty() const { return groups_.empty(); }
    /// Take up impacts of one moment, in their order.
    ///
    /// Returns those whose groups come a rounding later than the first of all: something else may happen before.
    [[nodiscard]] std::vector<Event> put(const BodyRows& bodies, const StaticSurfaces& surfaces,
                                         std::vector<Event> impacts);
    /// The next group, without what was overtaken in the meantime: empty where all of it was. Only where there is one.
    [[nodiscard]] std::vector<Event> take(const BodyRows& bodies);
    void clear() { groups_.clear(); }

private:
    std::vector<std::vector<Event>> groups_; // the next comes last
};

/// Two bodies touch at the moment of another impact, and not only at that of their own: the gap that they still have is
/// less than the tolerance of touching.
/// time  of the other impact, the earlier one [s]
[[nodiscard]] bool is_at_once(const BodyRows& bodies, const Event& impact, double time);

} // namespace flying
