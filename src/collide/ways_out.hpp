#pragma once

#include <optional>

#include "math/vec2.hpp"

namespace flying {

/// The ways out of a corner: all between the outward normals of its two sides, which turn from one to the other by less
/// than half a turn.
struct WaysOut
{
    Vec2 first = Vec2::Zero(); ///< normal of the side that ends at the corner
    Vec2 last = Vec2::Zero();  ///< of the one that starts there, counterclockwise of the other

    [[nodiscard]] bool has(const Vec2& way) const;
};

/// The ways from A to B that lead out of A's corner, and back out of B's: where the corners lie on each other, along
/// these they part. Nothing where there is none.
[[nodiscard]] std::optional<WaysOut> ways_apart(const WaysOut& a, const WaysOut& b);

/// Where two corners lie on each other, and slide past each other along one of their sides, they don't strike: the
/// normal of that side. The far edge of a gap in a floor is no step to a box that slides on the level of both.
///
/// a, b      of the corners, in one frame
/// way       from A's corner to B's [m]
/// velocity  of B's corner relative to A's [m/s]
/// touch     what is no deeper behind a side than this lies on it [m]
///
/// Returns a unit vector from A to B; nothing where the corners come at each other, or neither side is in reach.
[[nodiscard]] std::optional<Vec2> side_slid_along(const WaysOut& a, const WaysOut& b, const Vec2& way,
                                                  const Vec2& velocity, double touch);

} // namespace flying
