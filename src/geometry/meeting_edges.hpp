#pragma once

#include <cstddef>
#include <vector>

#include "math/vec2.hpp"

namespace flying {

/// An edge of a ring that is not checked yet.
struct GivenEdge
{
    std::size_t ring = 0;
    std::size_t from = 0;  ///< the ring's point where it starts
    std::size_t to = 0;    ///< and where it ends
    Vec2 a = Vec2::Zero(); ///< the two points [m]
    Vec2 b = Vec2::Zero();
};

/// How two edges meet: not at all, at a point that ends one of them or along a line, or in the midst of both.
enum class Meeting
{
    none,
    touch,
    cross
};

/// The first edge that an edge meets, and how many it meets.
struct Partner
{
    std::size_t edge = 0;
    int count = 0;
    Meeting meeting = Meeting::none;
};

/// For each edge, its partners among the edges after it. Neighbours in a ring meet where one runs back along the other;
/// all other edges where they share any point. Exact (math/orientation.hpp).
[[nodiscard]] std::vector<Partner> meeting_edges(const std::vector<GivenEdge>& edges);

} // namespace flying
