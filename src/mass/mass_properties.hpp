#pragma once

namespace flying {

/// What a shape of uniform density weighs, and how it resists turning.
struct MassProperties
{
    double mass = 0.0;              ///< [kg]
    double moment_of_inertia = 0.0; ///< about the centre of mass [kg m^2]
};

} // namespace flying
