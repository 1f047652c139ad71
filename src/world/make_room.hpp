#pragma once

#include "world/scene.hpp"

namespace flying {

/// Moves bodies that overlap apart, and those that reach through the box or into the core of a central field back, each
/// along the shortest way, again and again until the scene can be run. Static bodies stay. What `validate` finds besides
/// isn't touched.
///
/// scene  shapes, positions and angles as `validate` wants them
/// most   how far a body may be moved, in bounding radii of its own
///
/// False where it can't be done; the scene is then as it was.
[[nodiscard]] bool make_room(Scene& scene, double most);

/// The same, by no more than numbers of five digits explain: 0.86603 for the height of half a hexagon puts it 5e-6 deep
/// into the floor that it is meant to stand on.
///
/// False where that doesn't make the scene fit to run; it is then as it was.
[[nodiscard]] bool make_room_for_digits(Scene& scene);

} // namespace flying
