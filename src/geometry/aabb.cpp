#include "geometry/aabb.hpp"

#include <limits>

namespace flying {

Aabb bounding_box(const Shape& shape, const Pose& world_from_body)
{
    if (const auto* disc = std::get_if<Disc>(&shape)) {
        const Vec2 reach(disc->radius, disc->radius);
        return {world_from_body.position - reach, world_from_body.position + reach};
    }
    if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        const Vec2 first = world_from_body * polygon->vertices().front();
        Aabb box{first, first};
        for (const Vec2& vertex : polygon->vertices().subspan(1)) {
            const Vec2 point = world_from_body * vertex;
            box.min = box.min.cwiseMin(point);
            box.max = box.max.cwiseMax(point);
        }
        return box;
    }
    constexpr double k_infinite = std::numeric_limits<double>::infinity();
    return {Vec2(-k_infinite, -k_infinite), Vec2(k_infinite, k_infinite)};
}

} // namespace flying
