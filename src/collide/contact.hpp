#pragma once

#include <cstdint>

#include "math/vec2.hpp"

namespace flying {

/// One point at which two bodies A and B touch or overlap.
struct Contact
{
    Vec2 point = Vec2::Zero();  ///< in the world, midway between the two surfaces [m]
    Vec2 normal = Vec2::Zero(); ///< unit vector from A to B
    double separation = 0.0;    ///< gap along the normal, negative where they overlap [m]
    std::uint32_t feature = 0;  ///< names the pair of features that meet, by one number
};

/// All points at which one pair of convex shapes touches: two at the most.
struct Manifold
{
    Contact contacts[2];
    int count = 0;
};

} // namespace flying
