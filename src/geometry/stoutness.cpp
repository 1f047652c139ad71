#include "geometry/stoutness.hpp"

#include <limits>

#include "geometry/moments.hpp"

namespace flying {

double stoutness(const Shape& shape)
{
    if (const auto* disc = std::get_if<Disc>(&shape)) return 2.0 * disc->radius;
    const auto* polygon = std::get_if<Polygon>(&shape);
    if (!polygon) return std::numeric_limits<double>::infinity();
    double perimeter = 0.0;
    for (const Edge& edge : polygon->edges()) perimeter += edge.length;
    return 4.0 * moments_of(*polygon).area / perimeter;
}

} // namespace flying
