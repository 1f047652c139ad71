#pragma once

#include <vector>

#include "events/event_engine.hpp"

namespace flying {

/// Bodies that lean on something from the start: they touch what never moves, are pressed against it by gravity, and
/// neither come nor go; and all that touch such bodies in the same way, by whatever chain. In ascending order.
///
/// Left to the event engine they would fall through what rounding leaves between them, and bounce there without end.
///
/// engine  whose bodies have just been put where they are
/// field   there is one
[[nodiscard]] std::vector<int> find_leaning(const EventEngine& engine, const Field& field);

} // namespace flying
