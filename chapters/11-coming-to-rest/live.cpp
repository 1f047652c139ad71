#include <algorithm>
#include <array>
#include <cmath>

#include "live/pieces.hpp"
#include "lying.hpp"
#include "math/sine_cosine.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// height, restitution, time -> height of the hopping ball's lowest point by the closed form, end of its hops.
Answer hop(std::span<const double> of)
{
    const double e = std::clamp(of[1], 0.0, 0.99);
    return {{test::hop_height(of[0], e, of[2]), test::end_of_hops(of[0], e)}, {}};
}

/// g, slope, friction, time -> gravity along the slope and across it, how far a box has slid by then from rest.
Answer slide(std::span<const double> of)
{
    const SineCosine tilt = sine_cosine(of[1]);
    const double along = of[0] * tilt.sine;
    const double across = of[0] * tilt.cosine;
    const double acceleration = std::max(0.0, along - of[2] * across);
    return {{along, across, 0.5 * acceleration * of[3] * of[3]}, {}};
}

constexpr std::array k_pieces{Piece{"hop", 3, hop}, Piece{"slide", 4, slide}};

} // namespace

std::span<const Piece> pieces_of_rest() { return k_pieces; }

} // namespace flying::live
