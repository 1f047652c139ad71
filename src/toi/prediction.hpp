#pragma once

#include "collide/feature.hpp"
#include "math/roots.hpp"
#include "motion/body.hpp"
#include "motion/flight.hpp"
#include "motion/kepler.hpp"

namespace flying {

/// A body in free flight: its state at a moment of its own, and the constant acceleration it is
/// under, or the centre round which it flies.
struct Flyer
{
    BodyState state;
    Vec2 acceleration = Vec2::Zero();      ///< [m/s^2]; zero for a static body and under a centre's pull
    const CentralField* central = nullptr; ///< not owned; null for a static body and where no centre pulls
};

/// The flyer at another moment.  time  any [s]
[[nodiscard]] inline BodyState state_at(const Flyer& flyer, double time)
{
    return flyer.central ? flight(flyer.state, *flyer.central, time) : flight(flyer.state, flyer.acceleration, time);
}

/// What is known of the first impact of a pair.
struct Prediction
{
    enum class Kind
    {
        never,      ///< they don't meet as long as both fly on
        impact,     ///< they meet at `time`
        not_before, ///< nothing before `time`; ask again from there
        put_off,    ///< nothing before `time`, which is as far as was asked; ask the same again for more
    };
    Kind kind = Kind::never;
    double time = k_never; ///< [s]
    Feature feature;       ///< which features meet, for an impact
};

/// The same prediction, its features named from the other side.
[[nodiscard]] inline Prediction swapped(Prediction prediction)
{
    FeatureKind& kind = prediction.feature.kind;
    if (kind == FeatureKind::vertex_of_a) kind = FeatureKind::vertex_of_b;
    else if (kind == FeatureKind::vertex_of_b) kind = FeatureKind::vertex_of_a;
    return prediction;
}

} // namespace flying
