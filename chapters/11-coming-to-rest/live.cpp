#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "column.hpp"
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

/// boxes, mass of the uppermost over that of another, sweeps -> worst error of a force after them, the share of it that
/// one more sweep leaves, what it leaves in the long run by the closed forms or -1 where there is none; the forces
/// under the boxes from the floor up, and what they should be, in weights of a box.
Answer column(std::span<const double> of)
{
    const int count = std::clamp(static_cast<int>(of[0]), 1, 100);
    const int sweeps = std::clamp(static_cast<int>(of[2]), 0, 10000);
    std::vector<double> masses(static_cast<std::size_t>(count), 1.0);
    masses.back() = std::clamp(of[1], 1e-3, 1e3);
    test::ColumnSweeps swept(masses);
    double error = 1.0; // before the first no point bears anything
    for (int k = 0; k < sweeps; ++k) error = swept.sweep_once();
    Answer answer;
    for (int k = 0; k < count; ++k) answer.engine.push_back(swept.impulse(k));
    const std::vector<double> weights = test::weights_above(masses, 1.0);
    answer.engine.insert(answer.engine.end(), weights.begin(), weights.end());
    const double left = error > 0.0 ? swept.sweep_once() / error : 0.0;
    const double cosine = sine_cosine(0.5 * std::numbers::pi / count).cosine;
    const double top = masses.back();
    const double in_the_end = top == 1.0 ? cosine * cosine : count == 2 ? top / (1.0 + top) : -1.0;
    answer.engine.insert(answer.engine.begin(), {error, left, in_the_end});
    return answer;
}

constexpr std::array k_pieces{Piece{"hop", 3, hop}, Piece{"slide", 4, slide}, Piece{"column", 3, column}};

} // namespace

std::span<const Piece> pieces_of_rest() { return k_pieces; }

} // namespace flying::live
