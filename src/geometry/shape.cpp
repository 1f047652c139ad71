#include "geometry/shape.hpp"

#include <limits>

namespace flying {

double bounding_radius(const Shape& shape)
{
    if (const auto* disc = std::get_if<Disc>(&shape)) return disc->radius;
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return polygon->radius();
    return std::numeric_limits<double>::infinity();
}

} // namespace flying
