#pragma once

#include <optional>

#include "collide/contact.hpp"
#include "rest/rest_data.hpp"

namespace flying {

/// An approach of two bodies that rounding doesn't explain, of however slow a slide.
[[nodiscard]] bool comes_near(const RestData& data, const RestPair& pair, double approach);

/// Where all that two bodies touch is a corner of each, on the other's, and these slide past each other: the normal of
/// the side along which they do, from A to B. Nothing where they strike.
///
/// manifold        what they touch at
/// pose_a, pose_b  where they are then
[[nodiscard]] std::optional<Vec2> side_at_passing(const RestData& data, const RestPair& pair, const Manifold& manifold,
                                                  const Pose& pose_a, const Pose& pose_b);

} // namespace flying
