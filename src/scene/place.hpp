#pragma once

#include <optional>
#include <vector>

#include "math/random.hpp"
#include "world/scene.hpp"

namespace flying {

/// A direction, uniform over the circle: points are drawn in a square until one lies in its circle, for sines would
/// differ between machines.
[[nodiscard]] Vec2 random_direction(Random& random);

/// A point, uniform in the unit disc.
[[nodiscard]] Vec2 random_in_disc(Random& random);

/// A number with mean 0, variance 1 and nearly the bell curve: the sum of twelve uniform ones (it ends at +-6).
[[nodiscard]] double random_normal(Random& random);

/// Places for discs in a box, none overlapping another or a wall.
///
/// radii  of each disc, positive [m]
///
/// First at random, the largest discs first, each with a fixed number of tries. Where that fails, on a lattice of the
/// largest radius, rows straight or staggered, whichever leaves more room, with places drawn at random and each disc
/// shaken in the room it has. None where that is too narrow, too.
[[nodiscard]] std::optional<std::vector<Vec2>> place_apart(Random& random, const BoxDef& box,
                                                           const std::vector<double>& radii);

} // namespace flying
