#pragma once

#include <optional>

#include "geometry/polygon.hpp"
#include "math/rotation.hpp"

namespace flying {

/// The ways out of a corner: all between the outward normals of its two sides, which turn from one to the other by less
/// than half a turn.
struct WaysOut
{
    Vec2 first = Vec2::Zero(); ///< normal of the side that ends at the corner
    Vec2 last = Vec2::Zero();  ///< of the one that starts there, counterclockwise of the other

    /// beyond  of either end, what is no further still counts [sine]
    [[nodiscard]] bool has(const Vec2& way, double beyond = 0.0) const
    {
        return cross(first, way) >= -beyond && cross(way, last) >= -beyond;
    }
};

[[nodiscard]] inline WaysOut ways_out(const Polygon& polygon, int vertex)
{
    return {polygon.edges()[polygon.previous(vertex)].normal, polygon.edges()[vertex].normal};
}

[[nodiscard]] inline WaysOut operator*(const Rotation& rotation, const WaysOut& ways)
{
    return {rotation * ways.first, rotation * ways.last};
}

/// Where two corners lie on each other, and slide past each other along one of their sides, they don't strike: the
/// normal of that side. The far edge of a gap in a floor is no step to a box that slides on the level of both.
///
/// a, b      of the corners, in one frame
/// way       from A's corner to B's [m]
/// velocity  of B's corner relative to A's [m/s]
/// touch     what is no deeper behind a side than this lies on it [m]
///
/// Returns a unit vector from A to B; nothing where the corners come at each other, or one is behind the side.
[[nodiscard]] std::optional<Vec2> side_slid_along(const WaysOut& a, const WaysOut& b, const Vec2& way,
                                                  const Vec2& velocity, double touch);

} // namespace flying
