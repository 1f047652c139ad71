#include <array>
#include <cmath>

#include "live/pieces.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// mean of the squared speeds, then speeds -> on paper: for each speed the density of
/// Maxwell's law in the plane, s/m.
Answer maxwell(std::span<const double> of)
{
    Answer answer;
    for (const double v : of.subspan(1))
        answer.paper.push_back(2.0 * v / of[0] * std::exp(-v * v / of[0]));
    return answer;
}

constexpr std::array k_pieces{Piece{"maxwell", 1, maxwell}};

} // namespace

std::span<const Piece> pieces_of_events()
{
    return k_pieces;
}

} // namespace flying::live
