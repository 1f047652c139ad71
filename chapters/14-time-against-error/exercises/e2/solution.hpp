#pragma once

#include "../../precision.hpp"

/// The time at which an engine has this error, on the straight line between two of its points on
/// logarithmic axes.
/// a, b   different errors, both positive
/// error  between theirs, positive          returns [s]
inline double time_between(const flying::work::Point& a, const flying::work::Point& b, double error)
{
    const double share = std::log(error / a.error) / std::log(b.error / a.error);
    return a.seconds * std::pow(b.seconds / a.seconds, share);
}
