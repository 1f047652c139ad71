#pragma once

#include <span>

#include "collide/seams.hpp"
#include "geometry/shape.hpp"
#include "math/tolerance.hpp"
#include "toi/prediction.hpp"

namespace flying {

/// Options of a prediction that cost time and change no bit; and what is known of the two bodies beside their shapes.
struct PredictOptions
{
    int windows = 16;               ///< how many windows of turning features to look at before answering `not_before`
    double horizon = k_never;       ///< nothing later is asked for, where the search begins with the first window [s]
    bool skips_far_features = true; ///< leave features alone until the bounding circles meet
    bool skips_apart_rings = true;  ///< leave bodies alone whose rings don't overlap
    bool skips_far_vertices = true; ///< leave vertices alone that stay out of reach
    std::span<const Seam> seams_a = {}; ///< where A's surface goes on over what lies beside it
    std::span<const Seam> seams_b = {}; ///< the same of B
};

/// Moment from which a pair can be predicted: the later of the two states' own.  [s]
[[nodiscard]] inline double common_start(const Flyer& a, const Flyer& b)
{
    return a.state.time > b.state.time ? a.state.time : b.state.time;
}

/// Sum of two bounding radii, with room for the rounding of the times at which it is entered and left.  [m]
[[nodiscard]] inline double bounding_reach(double reach) { return reach * (1.0 + tolerance::k_bounding_margin); }

/// When two bodies first touch, approaching.
///
/// a, b             not overlapping at common_start(flyer_a, flyer_b), though they may touch; not both static
/// flyer_a, flyer_b their flight; a half-plane's plays no part
/// from             common_start(flyer_a, flyer_b), or the time of an earlier `not_before` of the same pair   [s]
///
/// The answer depends on the two flights alone: asking again from a `not_before` leads to the same bits as one long look.
/// An impact is found when its gap is down to the rounding of the coordinates; touching without approach is no impact.
[[nodiscard]] Prediction predict(const Shape& a, const Flyer& flyer_a, const Shape& b, const Flyer& flyer_b, double from,
                                 const PredictOptions& options = {});

} // namespace flying
