#include <array>

#include "billiard.hpp"
#include "live/pieces.hpp"
#include "toi/discs.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// offset across, speed, mass of A, mass of B, restitution, time -> when the two meet (-1
/// where they don't). On paper: places of A and B at that time by the two closed forms. A
/// comes from 3 m left of B, which rests; both have a radius of half a metre.
Answer meeting(std::span<const double> of)
{
    discs::Disc a{-3.0, of[0], of[1], 0.0, 0.5, of[2]};
    discs::Disc b{0.0, 0.0, 0.0, 0.0, 0.5, of[3]};
    const double meet = time_to_meet(Vec2(a.x, a.y), Vec2(a.vx, a.vy), a.r + b.r);
    const double before = of[5] < meet ? of[5] : meet;
    const auto fly = [](discs::Disc& d, double t) { d.x += t * d.vx, d.y += t * d.vy; };
    fly(a, before);
    if (of[5] > meet) {
        discs::strike(a, b, of[4]);
        fly(a, of[5] - meet);
        fly(b, of[5] - meet);
    }
    return {{meet == k_never ? -1.0 : meet}, {a.x, a.y, b.x, b.y}};
}

/// ratio of the masses, time -> on paper: how many impacts there will be, places of the
/// light ball and of the heavy one.
Answer unfolded(std::span<const double> of)
{
    const BilliardPlaces places = billiard_places(of[0], of[1]);
    return {{},
            {static_cast<double>(whole_steps_below_pi(billiard_angle(of[0]))), places.light,
             places.heavy}};
}

constexpr std::array k_pieces{Piece{"meeting", 6, meeting}, Piece{"unfolded", 2, unfolded}};

} // namespace

std::span<const Piece> pieces_of_two_balls()
{
    return k_pieces;
}

} // namespace flying::live
