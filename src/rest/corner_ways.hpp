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

/// Where two corners lie on each other, or as deep behind a side of the one as behind one of the other, each way
/// between these sides' normals parts them: the one in the middle, so that two cards that lean on each other are each
/// other's mirror. Nothing where sides lie on each other; nor where the ways open to a right angle, since then a body
/// slides along one side with nothing to fear from the other.
///
/// a, b  of the corners, in one frame
/// way   from A's corner to B's [m]
/// near  differences up to this are none [m]
///
/// Returns a unit vector from A to B.
[[nodiscard]] std::optional<Vec2> middle_way(const WaysOut& a, const WaysOut& b, const Vec2& way, double near);

} // namespace flying
