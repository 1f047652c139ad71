#pragma once

#include <cstdint>

/// A gas that is stopped, thrown back with all its velocities, and should end where it began.
namespace flying::stress {

struct Reversal
{
    int discs = 0;
    double collisions = 0.0; ///< of a disc on the way out, on average
    double farthest = 0.0;   ///< of any disc at the end from where it began [diameters]
    bool failed = false;
};

/// side * side discs at packing 0.3
[[nodiscard]] Reversal reverse_gas(int side, double collisions_a_disc, std::uint64_t seed);

} // namespace flying::stress
