#pragma once

#include "boxes.hpp"

// How many boxes each way compares in one look.
namespace flying {


struct Counts
{
    long overlapping = 0;
    long all = 0;
    long sweep = 0;
    long grid = 0;
};



inline Counts count(std::span<const BoxedBody> bodies, double radius)
{
    Counts counts;
    const long n = static_cast<long>(bodies.size());
    counts.all = n * (n - 1) / 2;
    counts.overlapping = static_cast<long>(pairs_of_all(bodies).size());

    Sweep sweep;
    sweep.line_up(bodies);
    sweep.for_each_side_by_side([&](const auto&, const auto&) {
        ++counts.sweep;
        return true;
    });

    counts.grid = pairs_of_grid(filled_grid(bodies, radius), bodies).compared;
    return counts;
}


} // namespace flying
