#include "rest/corner_ways.hpp"

#include <cmath>

#include "rest/rest_tolerance.hpp"

namespace flying {

std::optional<Vec2> middle_way(const WaysOut& a, const WaysOut& b, const Vec2& way, double near)
{
    const std::optional<WaysOut> both = ways_apart(a, b);
    if (!both) return std::nullopt;
    // A side that is turned by so little leaves no more than a closed gap at its far end
    const double turned = rest_tolerance::k_closed;
    const bool is_wide = !(both->first.dot(both->last) > turned);
    const bool is_side = !(cross(both->first, both->last) > turned);
    if (is_wide || is_side || std::abs((both->first - both->last).dot(way)) > near) return std::nullopt;
    return (both->first + both->last).normalized();
}

} // namespace flying
