#pragma once

#include <variant>

#include "math/vec2.hpp"

namespace flying {

/// No outside force: bodies fly straight.
struct NoField
{
};

/// The same acceleration everywhere, for every body that is not static.
struct UniformField
{
    Vec2 gravity = Vec2::Zero(); ///< [m/s^2]
};

/// The pull of a centre that stays where it is: every body that is not static is
/// accelerated by mu / r^2 towards it. Bodies don't attract each other. The centre may have
/// a solid core, a static disc.
struct CentralField
{
    Vec2 centre = Vec2::Zero(); ///< [m]
    double mu = 1.0;            ///< strength, positive [m^3/s^2]
    double radius = 0.0;        ///< of the core; 0 for none [m]
};

/// What acts on bodies from outside.
using Field = std::variant<NoField, UniformField, CentralField>;

/// Acceleration in a field that is the same everywhere; zero in any other.  [m/s^2]
[[nodiscard]] inline Vec2 uniform_acceleration(const Field& field)
{
    const auto* uniform = std::get_if<UniformField>(&field);
    return uniform ? uniform->gravity : Vec2(Vec2::Zero());
}

/// Acceleration at a place, which isn't the centre.  [m/s^2]
[[nodiscard]] inline Vec2 acceleration_at(const Field& field, const Vec2& place)
{
    const auto* central = std::get_if<CentralField>(&field);
    if (!central) return uniform_acceleration(field);
    const Vec2 x = place - central->centre;
    const double r = x.norm();
    return (-central->mu / (r * r * r)) * x;
}

/// Potential energy of a body, for each of its kilograms: zero at the origin of a uniform field, and infinitely far
/// from a centre.  [J/kg]
[[nodiscard]] inline double potential_at(const Field& field, const Vec2& place)
{
    const auto* central = std::get_if<CentralField>(&field);
    return central ? -central->mu / (place - central->centre).norm() : -uniform_acceleration(field).dot(place);
}

} // namespace flying
