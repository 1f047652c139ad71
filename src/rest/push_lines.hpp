#pragma once

#include "math/block_system.hpp"
#include "rest/contact_point.hpp"

namespace flying {

// A push on both bodies as six numbers: force and moment on A, the same on B.

[[nodiscard]] inline PairRow normal_line(const ContactPoint& c)
{
    return {{-c.n_x, -c.n_y, -c.normal_arm_a}, {c.n_x, c.n_y, c.normal_arm_b}};
}

[[nodiscard]] inline PairRow tangent_line(const ContactPoint& c)
{
    return {{c.n_y, -c.n_x, -c.tangent_arm_a}, {-c.n_y, c.n_x, c.tangent_arm_b}};
}

inline void add(double* target, double factor, const double* line)
{
    for (int i = 0; i < 3; ++i) target[i] += factor * line[i];
}

} // namespace flying
