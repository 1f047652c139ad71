#pragma once

namespace flying {


/// Mass that a finger feels which pushes a hinged body across.    [kg]
/// inertia   moment of inertia about the hinge      [kg m^2]
/// distance  from the hinge to the finger, not 0    [m]
[[nodiscard]] inline double mass_felt(double inertia, double distance)
{
    return inertia / (distance * distance);
}



/// Angle by which a constant force has turned a hinged body from rest.  [rad]
/// torque  force times its distance from the hinge  [N m]
[[nodiscard]] inline double angle_turned(double inertia, double torque, double time)
{
    return 0.5 * (torque / inertia) * (time * time);
}


} // namespace flying
