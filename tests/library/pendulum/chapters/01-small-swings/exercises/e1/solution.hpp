#pragma once

#include <numbers>

/// Length of a string by its period.  [m]
inline double length_of(double period, double g)
{
    const double share = period / (2.0 * std::numbers::pi);
    return share * share * g;
}
