#pragma once

#include "broadphase/grid.hpp"
#include "events/body_rows.hpp"
#include "events/foreseen.hpp"

namespace flying {

/// Ask the memory for what the events to come will read, so that it is there when they do: first the bodies' places,
/// then the rows of those that still count, then the cells about them, then the rows of the bodies in them. Pays for
/// more bodies than the fast memory holds.
void fetch_ahead(const ForeseenEvents& foreseen, const BodyRows& bodies, const Grid& cells);

} // namespace flying
