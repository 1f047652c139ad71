#include <algorithm>
#include <array>

#include "bar.hpp"
#include "live/pieces.hpp"
#include "response/impact.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// height of the bar's middle, spin, looseness of the bound -> the bound; of each look of the march: time, gap, rate.
/// On paper: when the bar strikes, by the arc sine.
Answer march(std::span<const double> of)
{
    const double y = of[0];
    const double spin = of[1];
    const MarchBounds bounds = bar_bounds(y, spin, of[2]);
    Answer answer{{bounds.bend}, {}};
    double time = 0.0;
    for (int look = 0; look < 500; ++look) {
        const EdgeReading now = read_corner(y, spin, time);
        answer.engine.insert(answer.engine.end(), {time, now.gap, now.gap_rate});
        if (strikes(now, bounds)) break;
        const double step = certain_step(now, bounds);
        if (!(step > 0.0)) break;
        time += step;
    }
    answer.paper = {bar_strikes(y, spin)};
    return answer;
}

/// height of the bar's middle, spin, restitution -> time of the strike, angle then, velocity y and spin after it.
Answer bounce(std::span<const double> of)
{
    const Flyer flyer = turning_bar(of[0], of[1]);
    const double found = predict(bar(), flyer, k_floor, {}, 0.0, {.windows = 1000}).time;
    const BodyState state = state_at(flyer, found);
    const Vec2 arm = Rotation::of(state.angle) * Vec2(k_half_length, -k_half_thickness);
    const double moment = (k_half_length * k_half_length + k_half_thickness * k_half_thickness) / 3.0;
    const ImpactPoint point{{0.0, 0.0}, arm, {0.0, 1.0}};
    const ImpactResult after =
        resolve_impact({}, {state.velocity, state.spin, {1.0, 1.0 / moment}}, {&point, 1}, {of[2], 0.0});
    return {{found, state.angle, after.velocity_b.y(), after.spin_b}, {}};
}

constexpr std::array k_pieces{Piece{"march", 3, march}, Piece{"bounce", 3, bounce}};

} // namespace

std::span<const Piece> pieces_of_bars()
{
    return k_pieces;
}

} // namespace flying::live
