#include <algorithm>
#include <array>

#include "falling.hpp"
#include "live/pieces.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// g, length of a step, time -> distance by whole steps and what is left of one; by the closed form.
Answer fall(std::span<const double> of)
{
    const double g = of[0];
    const double step = of[1];
    const double time = of[2];
    const int steps = static_cast<int>(std::clamp(time / step, 0.0, 1e6));
    const double whole = steps * step;
    const double by_steps = steps > 0 ? fall_by_steps(g, whole, steps) : 0.0;
    return {{by_steps + g * whole * (time - whole), fall_distance(g, time)}, {}};
}

constexpr std::array k_pieces{Piece{"fall", 3, fall}};

} // namespace

std::span<const Piece> pieces_of_falling() { return k_pieces; }

} // namespace flying::live
