#pragma once

#include "geometry/polygon.hpp"
#include "math/rotation.hpp"

/// The few bodies that this chapter lays on one another.
namespace flying::corner {

/// A box about its own centre.
inline Polygon box(double width, double height)
{
    const double x = 0.5 * width;
    const double y = 0.5 * height;
    return Polygon({{Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)}});
}

inline Pose at(double x, double y, double angle = 0.0)
{
    return {Vec2(x, y), Rotation::of(angle)};
}

/// A table on two legs: no convex shape.
inline Polygon table()
{
    return Polygon(
        {{Vec2(-3, 0), Vec2(-2, 0), Vec2(-2, 2), Vec2(2, 2), Vec2(2, 0), Vec2(3, 0), Vec2(3, 3), Vec2(-3, 3)}});
}

/// A plus sign of five squares.
inline Polygon plus()
{
    return Polygon({{Vec2(-3, -1), Vec2(-1, -1), Vec2(-1, -3), Vec2(1, -3), Vec2(1, -1), Vec2(3, -1), Vec2(3, 1),
                     Vec2(1, 1), Vec2(1, 3), Vec2(-1, 3), Vec2(-1, 1), Vec2(-3, 1)}});
}

/// A square frame, and a diamond a little too wide for its hole.
inline Polygon frame()
{
    return Polygon(
        {{Vec2(-2, -2), Vec2(2, -2), Vec2(2, 2), Vec2(-2, 2)}, {Vec2(-1, -1), Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1)}});
}

inline Polygon diamond()
{
    return Polygon({{Vec2(1.1, 0), Vec2(0, 0.5), Vec2(-1.1, 0), Vec2(0, -0.5)}});
}

} // namespace flying::corner
