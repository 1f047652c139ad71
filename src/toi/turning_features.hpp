#pragma once

#include <algorithm>
#include <span>

#include "collide/seams.hpp"
#include "geometry/disc.hpp"
#include "geometry/half_plane.hpp"
#include "geometry/polygon.hpp"
#include "toi/relative_flight.hpp"
#include "toi/safe_march.hpp"

namespace flying {

/// A stretch of time in which the features of one pair are looked at, and what bounds their
/// motion in it.
struct Window
{
    double from = 0.0;  ///< [s]
    double until = 0.0; ///< [s]
    double horizon = k_never; ///< nothing later is asked for; what happens before doesn't depend on it [s]
    double speed = 0.0; ///< bound on the relative speed of the two positions within it [m/s]
    bool skips_far_vertices = true; ///< leave those alone that stay out of reach
    GapTolerance tolerance;
    std::span<const Seam> seams_a = {}; ///< of A's surface with what lies beside it
    std::span<const Seam> seams_b = {}; ///< the same of B

    /// Half of the time that is looked at.  [s]
    [[nodiscard]] double half() const { return 0.5 * std::max(0.0, std::min(until, horizon) - from); }
};

/// First strike of a pair within a window; `tired` where a march gave up at `time`.
struct Strike
{
    MarchEnd::Kind kind = MarchEnd::Kind::none;
    double time = k_never;
    Feature feature;
};

/// relative  flight of A as seen from B; turning_a, turning_b  how they turn
/// The features of the answer are named from A's and B's side as they are given here.
/// Relative: RelativeFlight, or CentralPairFlight whose bound holds throughout the window
template <typename Relative>
[[nodiscard]] Strike first_strike(const Polygon& a, const Turning& turning_a, const Polygon& b, const Turning& turning_b,
                                  const Relative& relative, const Window& window);

/// Disc A against polygon B.
template <typename Relative>
[[nodiscard]] Strike first_strike(const Disc& a, const Polygon& b, const Turning& turning_b,
                                  const Relative& relative, const Window& window);

/// Disc A against disc B, where one of them falls and the other doesn't.
template <typename Relative>
[[nodiscard]] Strike first_strike(const Disc& a, const Disc& b, const Relative& relative, const Window& window);

/// Polygon A against a wall; `relative` is A's flight in the world.
template <typename Relative>
[[nodiscard]] Strike first_strike(const Polygon& a, const Turning& turning_a, const HalfPlane& wall,
                                  const Relative& relative, const Window& window);

} // namespace flying
