#pragma once

#include <optional>

#include "collide/separating_axis.hpp"

namespace flying {

/// An axis along which two convex polygons are apart, or none where they touch or overlap. Stops at the first it finds.
///
/// guess  the axis that parted the pair the last time, tried first; its separation and vertex don't matter
[[nodiscard]] inline std::optional<Axis> find_separating_axis(const Polygon& a, const Polygon& b, const Pose& a_from_b,
                                                              const std::optional<Axis>& guess = {})
{
    const Pose b_from_a = relative_pose(a_from_b, Pose());
    const auto try_edge = [&](Owner owner, int edge) {
        Axis axis = owner == Owner::a ? axis_of_edge(a, edge, b, a_from_b) : axis_of_edge(b, edge, a, b_from_a);
        axis.owner = owner;
        return axis;
    };

    // What parted the two a moment ago most often parts them still
    if (guess) {
        const Axis axis = try_edge(guess->owner, guess->edge);
        if (axis.separation > 0.0) return axis;
    }

    for (const Owner owner : {Owner::a, Owner::b}) {
        const int count = static_cast<int>(owner == Owner::a ? a.edges().size() : b.edges().size());
        for (int k = 0; k < count; ++k) {
            const Axis axis = try_edge(owner, k);
            if (axis.separation > 0.0) return axis;
        }
    }
    return std::nullopt;
}

} // namespace flying
