#pragma once

#include <vector>

#include "collide/separation.hpp"
#include "geometry/aabb.hpp"

namespace flying {

/// One body of a scene as the check of the start sees it.
struct PlacedBody
{
    int index = 0; ///< in the scene
    bool is_static = false;
    Pose pose;
    double size = 0.0; ///< bounding radius [m]
    Aabb box;
    CollisionShape shape;
};

/// Two bodies that overlap at the start.
struct StartOverlap
{
    int first = 0;      ///< the lower index in the scene
    int second = 0;     ///< the higher
    double depth = 0.0; ///< [m]
};

/// Overlap that rounding explains: of the numbers of the scene (tolerance::k_start_overlap times the size), and of the
/// coordinates themselves.
///
/// size   the smaller body's bounding radius                      [m]
/// reach  greatest coordinate that plays a part                   [m]
[[nodiscard]] double start_overlap_allowed(double size, double reach);

/// Pairs of bodies, not both static, that overlap by more than is allowed, ordered by second and first index. At most
/// `most` of them: a scene with all bodies in one place has more pairs than memory.
[[nodiscard]] std::vector<StartOverlap> find_start_overlaps(const std::vector<PlacedBody>& bodies, std::size_t most);

} // namespace flying
