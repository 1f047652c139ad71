#include "mass/disc.hpp"

#include <numbers>

namespace flying {

MassProperties disc_mass(double radius, double density)
{
    const double m = density * (std::numbers::pi * (radius * radius));
    const double moment_of_inertia = 0.5 * m * (radius * radius);
    return {m, moment_of_inertia};
}

} // namespace flying
