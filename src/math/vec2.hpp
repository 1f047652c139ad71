#pragma once

#include <Eigen/Core>
#include <cmath>

namespace flying {

/// A point or a free vector of the plane: x to the right, y up. Unit: that of the quantity.
using Vec2 = Eigen::Vector2d;

/// z component of a x b: positive where b lies counter-clockwise of a. [product of units]
[[nodiscard]] inline double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// omega x r, the velocity of a point at r on a body that turns at omega.
/// omega  angular velocity, counter-clockwise positive  [rad/s]
/// r      from the axis to the point           [m]
[[nodiscard]] inline Vec2 cross(double omega, const Vec2& r)
{
    return Vec2(-omega * r.y(), omega * r.x());
}

/// `a` turned a quarter counter-clockwise.
[[nodiscard]] inline Vec2 perp(const Vec2& a) { return Vec2(-a.y(), a.x()); }

/// x and y both finite.
[[nodiscard]] inline bool is_finite(const Vec2& a) { return std::isfinite(a.x()) && std::isfinite(a.y()); }

} // namespace flying
