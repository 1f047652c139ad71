#include <array>
#include <cmath>

#include "billiard.hpp"
#include "live/pieces.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// ratio of the masses, time -> on paper: how many impacts there will be, places of the light ball and of the heavy one.
Answer unfolded(std::span<const double> of)
{
    const BilliardPlaces places = billiard_places(of[0], of[1]);
    return {{}, {static_cast<double>(whole_steps_below_pi(billiard_angle(of[0]))), places.light, places.heavy}};
}

/// mean of the squared speeds, then speeds -> on paper: for each speed the density of Maxwell's law in the plane, s/m.
Answer maxwell(std::span<const double> of)
{
    Answer answer;
    for (const double v : of.subspan(1)) answer.paper.push_back(2.0 * v / of[0] * std::exp(-v * v / of[0]));
    return answer;
}

constexpr std::array k_pieces{Piece{"unfolded", 2, unfolded}, Piece{"maxwell", 1, maxwell}};

} // namespace

std::span<const Piece> pieces_of_events() { return k_pieces; }

} // namespace flying::live
