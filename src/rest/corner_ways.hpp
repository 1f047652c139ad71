#pragma once

#include <optional>

#include "collide/ways_out.hpp"
#include "math/vec2.hpp"

namespace flying {

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
