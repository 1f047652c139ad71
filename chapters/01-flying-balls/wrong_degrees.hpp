#pragma once

#include <numbers>

#include "motion/body.hpp"

/// WRONG on purpose: see "Where it breaks".
namespace flying::wrong {

// [wrong.degrees]
enum class Kind
{
    ball,   ///< its angle is in radians
    polygon ///< its angle is in degrees
};

/// A point of the body, given in its own frame, in the world's.
[[nodiscard]] inline Vec2 point_of(Kind kind, const BodyState& body, const Vec2& r_local)
{
    const double degree = std::numbers::pi / 180.0;
    const double angle = kind == Kind::polygon ? body.angle * degree : body.angle;
    return body.position + Rotation::of(angle) * r_local;
}
// [wrong.degrees]

} // namespace flying::wrong
