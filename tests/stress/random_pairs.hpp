#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "geometry/shape.hpp"
#include "stress/dense_search.hpp"

namespace flying::stress {

/// A pair for the engine and the same for the dense search.
struct RandomPair
{
    Shape shape_a;
    Shape shape_b;
    FlyingPair flying;
    double start = 0.0;
    double horizon = 0.0;                ///< until when it is followed [s]
    std::unique_ptr<CentralField> field; ///< lent to the flyers where there is one
    bool is_grazing = false;
};

/// Pair number `seed`, the same on every machine but for rounding of the mathematical library: discs, planks from square
/// to slivers, regular polygons, stars, frames with a body within, walls; sizes up to a hundred apart; spins from none to
/// a thousand radians in the time a body takes to pass by; with no field, falling past what stands still, or round a
/// centre; some far from the origin; one in ten of those that pass by is aimed anew, so that it grazes by as little as
/// 1e-11 of its size.
[[nodiscard]] RandomPair random_pair(std::uint64_t seed);

/// What the engine's answer to a pair was, and whether it stands.
struct Verdict
{
    bool right = false;
    bool undecided = false;  ///< the dense search came to no end
    bool impact = false;     ///< foreseen by the engine before the horizon
    double gap = 0.0;        ///< at the impact [sizes of the smaller]
    long samples = 0;
    std::string why;         ///< where not right
};

/// What the engine says of a pair: asked again and again until there is an answer up to the horizon.
[[nodiscard]] Prediction foresee(const RandomPair& pair);

/// Hold an answer, the engine's or any other, against the dense search.
[[nodiscard]] Verdict judge(const RandomPair& pair, const Prediction& answer);

/// The same pair with all times later by `shift`: how far the root moved beyond it, in units of what rounding allows.
/// Negative where the pair doesn't fit: it grazes within that rounding.
[[nodiscard]] double shifted_root_error(RandomPair pair, double shift);

} // namespace flying::stress
