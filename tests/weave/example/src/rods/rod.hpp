#pragma once

namespace flying {

/// Moment of inertia of a thin rod about its end: m l^2 / 3.   [kg m^2]
/// m  mass    [kg]
/// l  length  [m]
[[nodiscard]] inline double rod_about_end(double m, double l)
{
    return m * l * l / 3.0;
}

/// The same about its middle.   [kg m^2]
[[nodiscard]] inline double rod_about_middle(double m, double l)
{
    return m * l * l / 12.0;
}

} // namespace flying
