#pragma once

#include <span>
#include <vector>

#include "rest/contact_point.hpp"

namespace flying {

/// One island as the direct solvers see it, and what they answer.
struct ContactProblem
{
    /// Where a point stands in the island.
    struct Seat
    {
        int a = 0;     ///< number of the body A among the members; as many as there are where it is static
        int b = 0;     ///< the same of the body B
        int edge = -1; ///< of the block system, where both move
    };

    std::span<const ContactPoint> points; ///< with the impulses that changes are sought from
    std::vector<Seat> seats;              ///< of each point
    std::vector<Mover> bodies;            ///< the members, with the velocities that they would have without contacts
    std::vector<double> slip;             ///< normal speed less the bound, and tangential speed, of each point [m/s]
    std::vector<double> impulse;          ///< normal and tangential, of each point: the answer [N s]
};

} // namespace flying
