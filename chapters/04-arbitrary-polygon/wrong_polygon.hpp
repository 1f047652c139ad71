#pragma once

#include <cmath>

#include "plain_sums.hpp"

namespace flying {


/// WRONG, and it looks right: the corners weigh nothing.
inline Vec2 vertex_mean(std::span<const Vec2> ring)
{
    Vec2 sum = Vec2::Zero();
    for (const Vec2& vertex : ring) sum += vertex;
    return sum / static_cast<double>(ring.size());
}



/// WRONG, and it looks right: an area is positive, so why not say so?
inline AreaMoments moments_without_sign(std::span<const Vec2> ring)
{
    const Vec2 centre = vertex_mean(ring);
    double area = 0.0;
    double second = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 a = ring[k] - centre;
        const Vec2 b = ring[(k + 1) % ring.size()] - centre;
        const double s = 0.5 * std::abs(cross(a, b));
        area += s;
        second += triangle_inertia(s, a, b);
    }
    return {area, centre, second};
}



/// WRONG, and on paper it is right: any point may be the common corner.
inline AreaMoments moments_about_origin(std::span<const Vec2> ring)
{
    return plain_moments(ring, Vec2::Zero());
}


} // namespace flying
