#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "math/vec2.hpp"

/// The oracle of chapter 5: moments of rings in exact rational numbers.
namespace flying::oracle {

using Rational = boost::multiprecision::cpp_rational;

struct Moments
{
    Rational area;
    Rational x; ///< of the centroid
    Rational y;
    Rational second_moment; ///< about the centroid
};

/// Rings count with the sign of their turning. By trapezia down to the axes (Green's theorem), not by triangles.
[[nodiscard]] inline Moments moments_of_rings(const std::vector<std::vector<Vec2>>& rings)
{
    Rational area = 0;
    Rational first_x = 0;
    Rational first_y = 0;
    Rational xx = 0;
    Rational yy = 0;
    for (const std::vector<Vec2>& ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vec2& a = ring[k];
            const Vec2& b = ring[(k + 1) % ring.size()];
            const Rational ax(a.x());
            const Rational ay(a.y());
            const Rational bx(b.x());
            const Rational by(b.y());
            const Rational dx = bx - ax;
            const Rational dy = by - ay;

            // Integrals along the edge: of x dy, x^2/2 dy, -y^2/2 dx, x^3/3 dy, -y^3/3 dx
            area += dy * (ax + bx) / 2;
            first_x += dy * (ax * ax + ax * bx + bx * bx) / 6;
            first_y -= dx * (ay * ay + ay * by + by * by) / 6;
            xx += dy * (ax * ax * ax + ax * ax * bx + ax * bx * bx + bx * bx * bx) / 12;
            yy -= dx * (ay * ay * ay + ay * ay * by + ay * by * by + by * by * by) / 12;
        }
    }
    const Rational x = first_x / area;
    const Rational y = first_y / area;
    return {area, x, y, xx + yy - area * (x * x + y * y)};
}

/// Distance of `found` from `exact`, in units of the last place of the latter.
[[nodiscard]] inline double ulps(double found, const Rational& exact)
{
    const double size = std::abs(static_cast<double>(exact));
    const double unit = std::nextafter(size, std::numeric_limits<double>::infinity()) - size;
    const Rational error = Rational(found) - exact;
    return std::abs(static_cast<double>(error)) / unit;
}

} // namespace flying::oracle
