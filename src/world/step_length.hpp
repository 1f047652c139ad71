#pragma once

#include "geometry/shape.hpp"
#include "motion/body.hpp"
#include "motion/field.hpp"

namespace flying {

// How long a step is, and where it ends. Where nothing else is said, `step` is the length of a whole one, > 0 [s].

/// The first multiple of the step's length, halved so often, after a moment, but for one that is all but reached.  [s]
[[nodiscard]] double next_end(double step, double time, int halvings);

/// Whole steps end there, and the last of those into which one is halved.
[[nodiscard]] bool ends_whole_step(double step, double time);

/// Of a step between two moments: a whole one, and one that was halved, has its length to the bit, whatever the
/// difference of its ends rounds to.  [s]
[[nodiscard]] double length_of_step(double step, double from, double end);

/// How fast a body changes places, by its size, or would after a fall of a few sizes: what small bodies bear in a step
/// is in proportion to that. A disc that spins on the spot is as fast as one that rolls, at most.  [1/s]
/// radius  of its bounding circle [m]
[[nodiscard]] double pace_of(const BodyState& state, const Shape& shape, double radius, const Field& field);

/// How often the step must be halved for bodies to stay within a small part of their size.
/// pace  of the fastest [1/s]
[[nodiscard]] int halvings_for(double step, double pace);

} // namespace flying
