#include "geometry/shape.hpp"

#include <algorithm>
#include <limits>

namespace flying {

double bounding_radius(const Shape& shape)
{
    if (const auto* disc = std::get_if<Disc>(&shape)) return disc->radius;
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return polygon->radius();
    return std::numeric_limits<double>::infinity();
}

double least_width(const Shape& convex)
{
    if (const auto* disc = std::get_if<Disc>(&convex)) return 2.0 * disc->radius;
    double width = std::numeric_limits<double>::infinity();
    const auto* polygon = std::get_if<Polygon>(&convex);
    if (!polygon) return width;
    for (const Edge& edge : polygon->edges()) {
        double deepest = 0.0;
        for (const Vec2& vertex : polygon->vertices())
            deepest = std::max(deepest, edge.normal.dot(polygon->vertices()[edge.from] - vertex));
        width = std::min(width, deepest);
    }
    return width;
}

} // namespace flying
