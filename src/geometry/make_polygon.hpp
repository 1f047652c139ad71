#pragma once

#include <span>
#include <vector>

#include "geometry/polygon.hpp"
#include "math/expected.hpp"

namespace flying {

/// A polygon about its own centre of mass, and where that centre was.
struct CentredPolygon
{
    Polygon polygon;              ///< its area centroid is the origin, to rounding
    Vec2 centroid = Vec2::Zero(); ///< of the input, in the input's frame [m]
};

/// The one checked door to polygons: turns rings the right way round, drops vertices that repeat their neighbour, moves
/// the area centroid to the origin, and refuses what is no simple polygon.
///
/// outer  three vertices or more, either way round, anywhere; finite                             [m]
/// holes  rings strictly inside the outer one and outside each other, either way round           [m]
///
/// Faults, all of them together, placed at `vertices`, `vertices[i]`, `holes[k]` or `holes[k][i]`: coordinates that are
/// not finite, or so large or small that their squares are not; fewer than three distinct vertices; no area; two edges
/// of one ring that cross or touch; a hole that crosses or touches another ring, lies outside, or lies within another.
/// Crossing is decided exactly (math/orientation.hpp).
[[nodiscard]] Expected<CentredPolygon> make_polygon(std::span<const Vec2> outer,
                                                    std::span<const std::vector<Vec2>> holes = {});

} // namespace flying
