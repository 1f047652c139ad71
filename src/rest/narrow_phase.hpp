#pragma once

#include <vector>

#include "collide/manifold.hpp"
#include "collide/seams.hpp"
#include "rest/pair_list.hpp"
#include "rest/rest_bodies.hpp"

namespace flying {

/// By how much any separation along an edge of the two of a pair may differ, at these poses, from what the last look
/// from where they were has found.  [m]
[[nodiscard]] double change_since_look(const RestBodies& bodies, const RestPair& pair, const Pose& pose_a,
                                       const Pose& pose_b);

/// Where pairs touch, as the surfaces of their bodies really are: without cuts (rest/outline_points.hpp), and with
/// neighbours that lie flush taken as one surface (collide/seams.hpp).
class NarrowPhase
{
public:
    explicit NarrowPhase(const RestBodies& bodies);

    /// The points at which a pair touches or might soon touch, with the two bodies at these poses.
    /// pairs   all that may touch; those beside the pair tell what lies flush with it and moves with it
    /// margin  points further apart than this make no contact [m]
    [[nodiscard]] Manifold look(const RestBodies& bodies, const PairList& pairs, const RestPair& pair,
                                const Pose& pose_a, const Pose& pose_b, double margin) const;
    /// The same from where the bodies are; what the last such look has found may answer.
    [[nodiscard]] Manifold find_cached(const RestBodies& bodies, const PairList& pairs, RestPair& pair,
                                       double margin) const;

private:
    void mend(const RestBodies& bodies, const PairList& pairs, const RestPair& pair, const Pose& pose_a,
              const Pose& pose_b, double margin, Manifold& manifold) const;

    std::vector<std::vector<double>> widths_;           // of each body and part [m]
    std::vector<std::vector<std::vector<Seam>>> seams_; // of each body and part, with neighbours where neither moves
};

} // namespace flying
