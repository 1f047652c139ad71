#pragma once

#include "geometry/shape.hpp"
#include "math/expected.hpp"
#include "world/scene.hpp"

namespace flying {

/// The shape that a definition describes, about its centre of mass.
///
/// def  any values; faults are placed relative to the shape, such as `radius`, `sides[1]` or `vertices[2]`, and come
///      all together: numbers not finite or out of range, polygons that `make_polygon` refuses
[[nodiscard]] Expected<Shape> make_shape(const ShapeDef& def);

} // namespace flying
