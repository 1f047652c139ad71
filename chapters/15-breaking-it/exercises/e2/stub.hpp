#pragma once

#include <cmath>

/// How many cases have to go well before a fault in the share p of all of them would have been seen.
/// p      0 < p < 1
/// alpha  the luck that is left, 0 < alpha < 1
inline double tries_needed(double p, double alpha)
{
    (void)alpha;
    return 1.0 / p;
}
