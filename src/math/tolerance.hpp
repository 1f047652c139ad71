#pragma once

#include <limits>

/// Every tolerance of the engine, each with its unit and its reason. All are pure numbers: each is multiplied by a
/// length, time or speed taken from the shapes at hand, so that no scale is built in.
namespace flying::tolerance {

/// Distance between 1 and the next double: relative size of two roundings.
inline constexpr double k_epsilon = std::numeric_limits<double>::epsilon();

/// [body sizes] Surfaces this close, beyond the rounding of their coordinates, count as touching when an impact gathers
/// all the points at which its two bodies meet. A tenth of the gap that the accuracy contract allows at an event.
inline constexpr double k_touch = 1e-13;

/// [ulp of the coordinates] What rounding does to the gap between two features: each of the two points is a sum of a
/// position and a turned vertex, and the distance takes a difference and a product more.
inline constexpr double k_coordinate_roundings = 8.0;

/// That rounding, for coordinates that reach so far.  [their unit]
[[nodiscard]] constexpr double coordinate_rounding(double reach) { return k_coordinate_roundings * k_epsilon * reach; }

/// [body sizes] Starting overlap that rounding explains, beside the rounding of the coordinates: the same as touching,
/// so that what is let in at the start is seen as contact by the first prediction.
inline constexpr double k_start_overlap = k_touch;

/// [speeds of the bodies] Normal velocities below this are rounding: the velocity of a point is a sum of two products,
/// seen along a turned normal.
inline constexpr double k_approach = 32.0 * k_epsilon;

/// [arm over distance] The arm of a normal that goes through the centre of mass, after rounding: a cross product of a vector with its own
/// direction.
inline constexpr double k_central = 4.0 * k_epsilon;

/// [sine] Normals that differ by less are those of one straight edge, after rounding of its turning.
inline constexpr double k_same_normal = 8.0 * k_epsilon;

/// [work of the push] Impulses whose work differs by less do the same; the mean of all such is taken.
inline constexpr double k_same_work = 1e-12;

/// [radii] Margin of a bounding circle, for the rounding of the times at which it is entered and left.
inline constexpr double k_bounding_margin = 1e-9;

/// [bend] Margin of a bound on second derivatives, for the rounding of its own sum.
inline constexpr double k_bend_margin = 1e-9;

/// [polygon's size] Two vertices closer than this are taken for one by validation; below it the direction of the edge
/// between them would be mostly rounding.
inline constexpr double k_shortest_edge = 1e-12;

/// [square of polygon's size] Areas below this are no area: rounding of the sum of the signed triangles reaches it.
inline constexpr double k_smallest_area = 1e-14;

/// [units of length] Range of coordinates, zero aside: no length of the shapes, but the range of doubles. The fourth
/// power of the greatest, which second moments need, is finite.
inline constexpr double k_greatest_coordinate = 1e72;

/// [units of length] The error of the product of two such numbers is a double still, so that orientation stays exact.
inline constexpr double k_least_coordinate = 1e-140;

/// [units of length] The fourth power of this length, with twice the digits, is a double still.
inline constexpr double k_least_size = 1e-72;

/// [units of speed] The square of what is slower, with twice the digits, is no double any more: such an approach may never
/// end, nor a search for the next one.
inline constexpr double k_least_speed = 0x1p-459;

} // namespace flying::tolerance
