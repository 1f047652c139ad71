#pragma once

#include <algorithm>
#include <vector>

/// Impulses below each body of a column after some sweeps.  [N s]
///
/// masses  from the floor up [kg]
/// fall    speed at which all fall before the first sweep [m/s]
inline std::vector<double> forces(const std::vector<double>& masses, double fall, int sweeps)
{
    const std::size_t count = masses.size();
    std::vector<double> impulse(count, 0.0);
    std::vector<double> v(count, -fall);
    for (int s = 0; s < sweeps; ++s) {
        for (std::size_t k = 0; k < count; ++k) {
            // End the approach of this point alone, without ever pulling
            const double below = k > 0 ? v[k - 1] : 0.0;
            const double gives_way = (k > 0 ? 1.0 / masses[k - 1] : 0.0) + 1.0 / masses[k];
            const double sum = std::max(0.0, impulse[k] - (v[k] - below) / gives_way);
            const double j = sum - impulse[k];
            impulse[k] = sum;
            v[k] += j / masses[k];
            if (k > 0) v[k - 1] -= j / masses[k - 1];
        }
    }
    return impulse;
}
