#pragma once

#include <span>
#include <vector>

#include "response/push_line.hpp"

namespace flying {

/// The points that bear the impact of others with (nearly) the same normal: of each such group the two outermost along
/// the tangent, or one where they coincide. Between two points of one normal the normal speed is linear: what
/// stops the two stops the rest.
///
/// points  frames of the points, in any order
/// chosen  indices into `points` of those to look at; kept in their order
[[nodiscard]] std::vector<int> outermost(std::span<const PointFrame> points, std::span<const int> chosen);

/// Which points an impact pushes, and how the push is turned into rebound.
enum class Rebound
{
    by_restitution, ///< impulses (1 + e) times those that stop the points
    none            ///< the points are stopped, and nothing more
};

/// The push that two bodies give each other at several points at once, approaching or resting on each other.
///
/// Compression: impulses that end the approach of all points at once, each pushing, never pulling, with friction in
/// Coulomb's cone against the slip that is left, or holding. Restitution: (1 + e) times as much along the normals, and
/// along the tangents the part of (1 + e) times as much that loses most energy, so that slip is stopped and not
/// reversed. Without friction this is Newton's law at every point that is pushed. With it, energy never rises:
/// p the impulses of compression, v the speeds before, v_c = v + K p after it, p.v_c <= 0 by Coulomb's law; the work of
/// (1 + e) p is (1 + e) p.(v + (1 + e) K p / 2) <= (1 + e)(1 - e) p.v / 2 <= 0, and the tangents only take more.
///
/// Normals that face each other can lock two bodies so that impulses grow without bound; what rounding then leaves is
/// taken off by a push without rebound, in this round and the next.
///
/// points  frames of the points, at most a few: the time grows with the cube of their number
/// speed   all speeds at hand: tolerances are relative to it               [m/s]
[[nodiscard]] PairPush push_at_several(std::span<const PointFrame> points, const PairMotion& motion,
                                       const PairInertia& inertia, const Material& material, double speed,
                                       Rebound rebound);

} // namespace flying
