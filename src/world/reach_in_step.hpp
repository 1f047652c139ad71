#pragma once

#include "geometry/aabb.hpp"
#include "geometry/shape.hpp"
#include "motion/field.hpp"
#include "toi/prediction.hpp"
#include "world/hand_over.hpp"

namespace flying {

// Bounds on where bodies can get before a step ends, for the rules of handing over.

/// How far a flight leads, at most, from the straight way between its ends; infinite where it may pass the centre.  [m]
/// from  its beginning [s]
/// left  how long it lasts [s]
[[nodiscard]] double bow_of(const Flyer& flyer, double from, double left);

/// Holds all of a flight between two moments; without end where it may pass the centre.
/// radius  of the body's bounding circle [m]
[[nodiscard]] Aabb flight_box(const Flyer& flyer, double radius, double from, double until);

/// No less than the field at a place, and wherever a body may fall from there in a step.  [m/s^2]
[[nodiscard]] double greatest_pull(const Field& field, const Vec2& place);

/// What the rules of handing over need to know of a body that leans.
/// radius  of its bounding circle [m]
/// step    length of a whole step [s]
[[nodiscard]] Leaning leaning_of(int body, const Shape& shape, const BodyState& state, double radius,
                                 const Field& field, double step);

} // namespace flying
