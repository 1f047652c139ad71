#include "rest/corner_ways.hpp"

#include <cmath>

#include "rest/rest_tolerance.hpp"

namespace flying {

std::optional<Vec2> middle_way(const WaysOut& a, const WaysOut& b, const Vec2& way, double near)
{
    const WaysOut into_b{-b.first, -b.last};
    const WaysOut both{into_b.has(a.first) ? a.first : into_b.first, into_b.has(a.last) ? a.last : into_b.last};
    if (!a.has(both.first)) return std::nullopt;
    // A side that is turned by so little leaves no more than a closed gap at its far end
    const double turned = rest_tolerance::k_closed;
    const bool is_wide = !(both.first.dot(both.last) > turned);
    const bool is_side = !(cross(both.first, both.last) > turned);
    if (is_wide || is_side || std::abs((both.first - both.last).dot(way)) > near) return std::nullopt;
    return (both.first + both.last).normalized();
}

} // namespace flying
