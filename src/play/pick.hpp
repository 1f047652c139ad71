#pragma once

#include <optional>
#include <string>

#include "world/world.hpp"

namespace flying {

/// Whether a point lies in a shape, its rim included for a disc.  local  in the shape's frame [m]
[[nodiscard]] bool holds(const Shape& shape, const Vec2& local);

/// The body that was drawn last of those under a point; where there is none, the nearest whose centre lies within `near`.
/// -1 for none.  point, near  [m]
[[nodiscard]] int body_at(const World& world, const Vec2& point, double near);

/// Why a shape can't stand there: the name of a body, a wall or the core that it would overlap; none where it can.
/// except  a body that is left out of account; -1 for none
[[nodiscard]] std::optional<std::string> obstacle(const World& world, const Shape& shape, const Pose& pose, int except);

} // namespace flying
