#pragma once

#include <span>
#include <string>
#include <vector>

#include "math/expected.hpp"
#include "math/vec2.hpp"

namespace flying {

/// One ring of a polygon to be, on its way through the checks of `make_polygon`.
struct GivenRing
{
    std::string place;         ///< what faults call it: `vertices` or `holes[2]`
    std::vector<Vec2> points;  ///< its vertices; repeated ones are dropped on the way [m]
    std::vector<int> indices;  ///< of each point among the vertices as they were given
    bool is_checkable = true;  ///< fit for the checks that follow
    bool meets_itself = false; ///< two of its edges cross or touch
    bool meets_another = false;
};

/// Place of the ring's vertex `k`, such as `holes[0][7]`.
[[nodiscard]] std::string place_of(const GivenRing& ring, std::size_t k);

/// Refuses numbers that are not finite, or whose products would overflow or lose digits. The ring is checkable
/// afterwards only where there are none.
void check_numbers(GivenRing& ring, Faults& faults);

/// Longer side of the smallest box about the ring [m], 0 where there is none. Refuses a size whose fourth power is no
/// number.
double check_size(GivenRing& ring, Faults& faults);

/// Drops vertices that lie within `distance` of the one before, and refuses a ring of fewer than three others.
void check_count(GivenRing& ring, double distance, Faults& faults);

/// Refuses edges that cross or touch, within a ring and between rings; neighbours may share their common vertex only.
/// Each edge is placed once, with the first edge that it meets.
void check_edges(std::span<GivenRing> rings, Faults& faults);

/// Refuses a ring whose area is rounding.
void check_area(const GivenRing& ring, Faults& faults);

/// Refuses holes that lie outside the first ring, or inside one another.
void check_nesting(std::span<const GivenRing> rings, Faults& faults);

} // namespace flying
