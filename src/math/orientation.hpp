#pragma once

#include "math/vec2.hpp"

namespace flying {

/// Sign of the turn a -> b -> c: +1 counter-clockwise, -1 clockwise, 0 exactly on one line. Exact for all coordinates
/// that are zero or between 2^-480 and 2^500 in size: signs decide some cases, a filter on the rounding error most
/// others, and the rest are summed by expansions (Shewchuk, "Adaptive precision floating-point arithmetic and fast
/// robust geometric predicates", 1997).
[[nodiscard]] int orientation(const Vec2& a, const Vec2& b, const Vec2& c);

} // namespace flying
