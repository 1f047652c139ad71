#include "collide/ways_out.hpp"

#include <cmath>

namespace flying {
namespace {

/// [sine] What goes along a side, but for so little, slides along it.
constexpr double k_along = 0x1p-26;

} // namespace

bool WaysOut::has(const Vec2& way) const
{
    return cross(first, way) >= 0.0 && cross(way, last) >= 0.0;
}

std::optional<WaysOut> ways_apart(const WaysOut& a, const WaysOut& b)
{
    const WaysOut into_b{-b.first, -b.last};
    const WaysOut both{into_b.has(a.first) ? a.first : into_b.first, into_b.has(a.last) ? a.last : into_b.last};
    if (!a.has(both.first) || !a.has(both.last)) return std::nullopt;
    return both;
}

std::optional<Vec2> side_slid_along(const WaysOut& a, const WaysOut& b, const Vec2& way, const Vec2& velocity,
                                    double touch)
{
    const std::optional<WaysOut> apart = ways_apart(a, b);
    if (!apart) return std::nullopt;
    const double aside = k_along * velocity.norm();
    for (const Vec2& normal : {apart->first, apart->last}) {
        if (normal.dot(velocity) >= -aside && normal.dot(way) >= -touch) return normal;
    }
    return std::nullopt;
}

} // namespace flying
