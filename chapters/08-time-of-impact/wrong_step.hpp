#pragma once

#include <cmath>

namespace flying {

/// WRONG, and it looks right: the safe step by the school formula.
inline double school_step(double f, double f_rate, double bend)
{
    return (f_rate + std::sqrt(f_rate * f_rate + 2.0 * bend * f)) / bend;
}

} // namespace flying
