#pragma once

#include <cmath>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "math/roots.hpp"
#include "math/rotation.hpp"

namespace flying {

/// WRONG, and it looks right: the quadratic formula from school.
inline double school_meet(const Vec2& x, const Vec2& v, double s)
{
    const double b = -x.dot(v);
    const double c = x.dot(x) - s * s;
    const double D = b * b - v.dot(v) * c;
    if (b <= 0.0 || D < 0.0) return k_never;
    return (b - std::sqrt(D)) / v.dot(v);
}

/// Two discs far apart, on paths that lie aslant.
struct FarPair
{
    Vec2 x; ///< from B's centre to A's [m]
    Vec2 v; ///< of A relative to B [m/s]
};

/// distance  along the path [m]; miss  by which the centres would pass each other [m]
inline FarPair far_pair(double distance, double miss)
{
    const Vec2 along = Rotation::of(0.4) * Vec2(1.0, 0.0);
    return {-distance * along + miss * perp(along), 3.0 * along};
}

/// When they meet, to twice the digits and more: but for the rounding of the given numbers.
inline double exactly(const FarPair& pair, double s)
{
    using Wide = boost::multiprecision::cpp_bin_float_100;
    const Wide x1(pair.x.x());
    const Wide x2(pair.x.y());
    const Wide v1(pair.v.x());
    const Wide v2(pair.v.y());
    const Wide b = -(x1 * v1 + x2 * v2);
    const Wide c = x1 * x1 + x2 * x2 - Wide(s) * s;
    const Wide D = b * b - (v1 * v1 + v2 * v2) * c;
    return static_cast<double>(c / (b + sqrt(D)));
}

} // namespace flying
