#pragma once

#include <span>

#include "geometry/moments.hpp"

namespace flying {


/// Moment of inertia of a triangle about one of its corners [kg m^2]
/// m     its mass [kg]
/// a, b  from that corner to the other two [m]
inline double triangle_inertia(double m, const Vec2& a, const Vec2& b)
{
    const Vec2 d = b - a;
    return 0.5 * m * (d.dot(d) / 3.0 + a.dot(d) + a.dot(a));
}



/// Moments of a ring by signed triangles about any point, in plain doubles.
/// o  the common corner of the triangles [m]
inline AreaMoments plain_moments(std::span<const Vec2> ring, const Vec2& o)
{
    double area = 0.0;
    Vec2 first = Vec2::Zero();
    double second = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 a = ring[k] - o;
        const Vec2 b = ring[(k + 1) % ring.size()] - o;
        const double s = 0.5 * cross(a, b);
        area += s;
        first += s / 3.0 * (a + b);
        second += triangle_inertia(s, a, b);
    }
    // From the common corner to the centroid
    const Vec2 centroid = first / area;
    second -= area * centroid.squaredNorm();
    return {area, o + centroid, second};
}


} // namespace flying
