#pragma once

#include <span>

#include "rest/rest_data.hpp"

namespace flying {

/// Bodies that lean on each other, by whatever chain of bodies that move, and the points between them.
struct Island
{
    std::span<const int> members;   ///< ascending
    std::span<ContactPoint> points; ///< those of a pair in a row
    bool is_exact = true;           ///< bodies move by the mean of their velocities; else by those at the end
    bool has_ways = false;          ///< places are found already, along curves
    bool is_solved = true;          ///< the impulses that were found are right to rounding
    bool in_turn = false;           ///< its impacts have moments of their own
    bool is_row = false;            ///< nothing is lost in it; no body meets more than two others, or presses on them
    double ended = 0.0;             ///< energy of approaches that were ended without rebound, at the start [J]
    double cut_at = 0.0;            ///< where its step is to end early, and to go on from; 0 if nowhere [s]

    [[nodiscard]] int member_count() const { return static_cast<int>(members.size()); }
    [[nodiscard]] int point_count() const { return static_cast<int>(points.size()); }
};

/// So large that all impacts which a step brings come at its start, and that it is swept where the direct solve doesn't
/// find its impulses at once. A row in which nothing is lost never is.
[[nodiscard]] bool is_heap(const Island& island);
/// So many bodies that each factorisation counts. Of fewer it costs little, and none is worth an overlap.
[[nodiscard]] bool is_large(const Island& island);
/// The heaviest of them weighs so many times as much as the lightest that sweeps hardly get on.
[[nodiscard]] bool are_unequal(const RestData& data, std::span<const int> members);
/// A few bodies move, as one that slides over a wall or rocks on it, and all others rest, or nearly.
/// share  of the speed that the field gives in a step: what is no faster rests
[[nodiscard]] bool hardly_any_moves(const RestData& data, const Island& island, double share);
/// Each of its bodies leans on fewer than three others that move, on average, as in a row or a tower: a load has hardly
/// more than one way through it. Sweeps take long to lead it along; a search that knows the ways finds it soon.
[[nodiscard]] bool is_chain(const RestData& data, const Island& island);
/// Each of its bodies leans on hardly more than one other that moves, as all that stands on a table leans on that: what
/// they do, and when, is found one by one though they are more than a dozen. Not in large islands.
[[nodiscard]] bool is_loose(const RestData& data, const Island& island);
/// All its impulses are looked for at once, to rounding: in islands that are not too large, in larger ones that stand
/// or begin to fall, or of which but a few bodies move, and in tall ones of any height, in which each body leans on
/// hardly more than one other: their equations stay sparse.
[[nodiscard]] bool is_solved_whole(const RestData& data, const Island& island);

/// The greatest velocity of any of these bodies, its rim's included.  [m/s]
[[nodiscard]] double greatest_speed(std::span<const Mover> movers, std::span<const double> radius,
                                    std::span<const int> members);
/// What the field gives in a step.  [m/s]
[[nodiscard]] double field_speed(const RestData& data, const Island& island);
/// The greater of that and the velocities with which the step begins.  [m/s]
[[nodiscard]] double top_speed(const RestData& data, const Island& island);
/// Speeds that the rounding of impulses explains.  [m/s]
[[nodiscard]] double solve_rounding(const Island& island);
/// Below what the field gives in a step by many orders, motion is the solve's rounding.  [m/s]
[[nodiscard]] double still_speed(const RestData& data, const Island& island);
/// None of it moved when the step began.
[[nodiscard]] bool stood(const RestData& data, const Island& island);
/// Nothing may take energy from an island: none of its contacts loses any, by impact or by friction.
[[nodiscard]] bool is_lossless(const Island& island);

/// A slip has ended, or turned round, between two sets of velocities.
/// still  slip below this has ended [m/s]
[[nodiscard]] bool any_slip_ended(const Island& island, std::span<const Mover> before, std::span<const Mover> after,
                                  double still);

/// What an island's contacts with static bodies leave of a motion that all its bodies have in common.
struct StaticHold
{
    int directions = 0;         ///< in which they resist: none, one, or 2 for several
    Vec2 normal = Vec2::Zero(); ///< of the only one

    [[nodiscard]] Vec2 leaves(const Vec2& motion) const
    {
        if (directions == 0) return motion;
        return directions == 1 ? Vec2(motion - normal.dot(motion) * normal) : Vec2(Vec2::Zero());
    }
};
[[nodiscard]] StaticHold static_hold(const RestData& data, std::span<const ContactPoint> points);

/// Takes all its bodies to be at a part of their ways.
void set_end_poses(RestData& data, const Island& island, double part);
void scale_impulses(const Island& island, double factor);
/// Points get what they bore at the end of the step before.
void recall_impulses(const RestData& data, const Island& island);

} // namespace flying
