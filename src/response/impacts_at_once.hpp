#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "response/impact.hpp"

namespace flying {

/// Two of many bodies, and the points at which they touch.
struct ImpactPair
{
    int a = 0;             ///< index of a body; normals point away from it
    int b = 0;             ///< index of another
    std::size_t first = 0; ///< index of its first point
    std::size_t end = 0;   ///< one past its last
    Material material;     ///< of the pair, as `combine` tells
    double rests = 0.0;    ///< what parts no faster than that rests [m/s]
};

/// Number the bodies of pairs anew, from 0, without gaps and in their order.
/// Returns the number that each had before.
[[nodiscard]] std::vector<int> number_anew(std::span<ImpactPair> pairs);

/// Let all bodies that touch at one moment strike each other, in rounds, until none approaches.
///
/// In each round every pair that approaches strikes, at the speeds that all have as the round begins. A pair that
/// shares no moving body with another such pair goes by the law of two bodies (`resolve_impact`). Pairs that share one
/// push together: compression ends the approach of all at once, and each gives back (1 + e) times as much along its
/// normals, with the part of the friction that loses most energy, as the points of one pair do. A pair that only rests
/// waits for the round in which something is thrown against it, so a row of balls that touch hands a blow on, one by
/// one. Immovable bodies that push a body along one normal are one, as tiles side by side, or slabs that overlap with
/// their tops level: a floor that is drawn of several pieces is a floor. How bodies and pairs are numbered alters
/// nothing but rounding, and mirrored bodies get mirrored answers.
///
/// However far compression has come (`PushTogether`), a push together never adds energy: it is scaled down to none
/// where it would. Bodies that it has hardly slowed wait until others strike them: it would do no more the next time.
/// They may be three that just fill a slot and of which the middle one, by a billionth above the line of the others,
/// wedges them apart.
///
/// bodies   their velocities are those before; on return those after
/// points   of all pairs; normals point from A to B
/// slowest  of each point: an approach that is slower is none [m/s]
/// most     impacts, after which what still approaches is left
/// Returns how many impacts there were; each pair that strikes in a round is one.
int resolve_impacts(std::span<ImpactBody> bodies, std::span<const ImpactPair> pairs,
                    std::span<const ImpactPoint> points, std::span<const double> slowest, int most);

} // namespace flying
