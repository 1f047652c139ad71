#include "collide/ways_out.hpp"

namespace flying {
namespace {

/// [sine] What comes at a side by less than this slides along it, and sides that differ by less are parallel.
constexpr double k_along = 0x1p-26;

} // namespace

std::optional<Vec2> side_slid_along(const WaysOut& a, const WaysOut& b, const Vec2& way, const Vec2& velocity,
                                    double touch)
{
    const double aside = k_along * velocity.norm();
    for (const Vec2& normal : {a.first, a.last, Vec2(-b.first), Vec2(-b.last)}) {
        const bool parts = a.has(normal, k_along) && b.has(-normal, k_along);
        if (parts && normal.dot(velocity) >= -aside && normal.dot(way) >= -touch) return normal;
    }
    return std::nullopt;
}

} // namespace flying
