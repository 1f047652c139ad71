#include "mass/polygon.hpp"

#include <limits>

#include "geometry/moments.hpp"
#include "mass/disc.hpp"

namespace flying {

MassProperties polygon_mass(const Polygon& polygon, double density)
{
    const AreaMoments moments = moments_of(polygon);
    return {density * moments.area, density * moments.second_moment};
}

MassProperties mass_of(const Shape& shape, double density)
{
    if (const auto* disc = std::get_if<Disc>(&shape)) return disc_mass(disc->radius, density);
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return polygon_mass(*polygon, density);

    constexpr double k_infinite = std::numeric_limits<double>::infinity();
    return {k_infinite, k_infinite};
}

} // namespace flying
