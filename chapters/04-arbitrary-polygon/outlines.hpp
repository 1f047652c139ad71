#pragma once

#include <cmath>
#include <vector>

#include "math/vec2.hpp"

/// The shapes of chapter 5, counter-clockwise, in whole centimetres.
namespace flying::outlines {

using Ring = std::vector<Vec2>;


inline Ring dumbbell()
{
    return {{40, 20},   {-40, 20}, {-40, 40}, {-80, 40}, {-80, -40}, {-40, -40},
            {-40, -20}, {40, -20}, {40, -40}, {80, -40}, {80, 40},   {40, 40}};
}


inline Ring house()
{
    return {{0, 0}, {100, 0}, {100, 100}, {50, 150}, {0, 100}};
}

/// A coordinate with 20 binary places: sums of such are exact, their products are not.
inline double on_grid(double x)
{
    return 0x1p-20 * std::floor(0x1p20 * x);
}

/// The house turned a little, so that no coordinate is a round number.
inline Ring tilted_house()
{
    Ring ring = house();
    for (Vec2& p : ring)
        p = Vec2(on_grid((12.0 * p.x() - 5.0 * p.y()) / 13.0), on_grid((5.0 * p.x() + 12.0 * p.y()) / 13.0));
    return ring;
}

inline Ring horseshoe()
{
    return {{0, 0}, {90, 0}, {90, 90}, {60, 90}, {60, 30}, {30, 30}, {30, 90}, {0, 90}};
}

/// About `centre`, counter-clockwise.
inline Ring square(const Vec2& centre, double side)
{
    const double r = 0.5 * side;
    return {centre + Vec2(-r, -r), centre + Vec2(r, -r), centre + Vec2(r, r), centre + Vec2(-r, r)};
}


/// The same outline with `more` corners on the edge that starts at corner k, where no
/// corner is needed.
inline Ring with_corners(const Ring& ring, std::size_t k, int more)
{
    Ring result;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        result.push_back(ring[i]);
        if (i != k) continue;
        const Vec2 along = ring[(k + 1) % ring.size()] - ring[k];
        for (int j = 1; j <= more; ++j) result.push_back(ring[k] + j * along / (more + 1));
    }
    return result;
}


inline Ring moved(Ring ring, const Vec2& offset)
{
    for (Vec2& vertex : ring) vertex += offset;
    return ring;
}

inline Ring reversed(const Ring& ring)
{
    return {ring.rbegin(), ring.rend()};
}

} // namespace flying::outlines
