#pragma once

#include "math/sine_cosine.hpp"
#include "math/vec2.hpp"

namespace flying {

/// A turn of the plane, as the cosine and the sine of its angle.
struct Rotation
{
    double cosine = 1.0;
    double sine = 0.0;

    /// angle  counter-clockwise  [rad]
    [[nodiscard]] static Rotation of(double angle)
    {
        const SineCosine sc = sine_cosine(angle);
        return {sc.cosine, sc.sine};
    }
};

/// `a` turned by the rotation.
[[nodiscard]] inline Vec2 operator*(const Rotation& q, const Vec2& a)
{
    return Vec2(q.cosine * a.x() - q.sine * a.y(), q.sine * a.x() + q.cosine * a.y());
}

/// One turn after another: (p * q) * a equals p * (q * a) to rounding.
[[nodiscard]] inline Rotation operator*(const Rotation& p, const Rotation& q)
{
    return {p.cosine * q.cosine - p.sine * q.sine, p.sine * q.cosine + p.cosine * q.sine};
}

/// The turn back.
[[nodiscard]] inline Rotation inverse(const Rotation& q) { return {q.cosine, -q.sine}; }

/// Where a body's own frame lies in the world.
struct Pose
{
    Vec2 position = Vec2::Zero(); ///< of the body's origin, its centre of mass [m]
    Rotation rotation;

    /// A point given in the body's frame, in the world's.
    [[nodiscard]] Vec2 operator*(const Vec2& local) const { return position + rotation * local; }
};

} // namespace flying
