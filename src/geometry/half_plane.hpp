#pragma once

#include "math/vec2.hpp"

namespace flying {

/// All points p with normal . p <= offset: a wall without thickness to pass through. Given in the world's frame; a body
/// of this shape is static and its pose plays no part.
struct HalfPlane
{
    Vec2 normal = Vec2(0.0, 1.0); ///< unit vector, out of the wall
    double offset = 0.0;          ///< of the surface along the normal, from the world's origin [m]
};

} // namespace flying
