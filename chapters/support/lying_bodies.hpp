#pragma once

#include <cmath>
#include <vector>

#include "rest/rest_engine.hpp"

/// Bodies that lie on floors, slopes and each other: for the chapters on rest, on heaps and on skips, and the tests of
/// `rest`.
namespace flying::test {

constexpr double k_gravity = 9.81; // [m/s^2]

/// A wall below everything in the direction of its normal.
inline RestBody wall(const Vec2& normal, double offset, const Material& material)
{
    RestBody body{HalfPlane{normal, offset}, {}, {}, material};
    body.is_static = true;
    return body;
}

/// A body of given mass and inertia that falls.
inline RestBody faller(Shape shape, const Vec2& position, double mass, double moment, const Material& material)
{
    RestBody body{std::move(shape), {}, {1.0 / mass, 1.0 / moment}, material};
    body.state.position = position;
    body.acceleration = Vec2(0.0, -k_gravity);
    return body;
}

inline Polygon rectangle(double width, double height)
{
    const double x = 0.5 * width;
    const double y = 0.5 * height;
    return Polygon({{Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)}});
}

inline RestBody box(double width, double height, const Vec2& position, double mass, const Material& material)
{
    return faller(rectangle(width, height), position, mass, mass * (width * width + height * height) / 12.0, material);
}

inline RestBody disc(double radius, const Vec2& position, double mass, const Material& material)
{
    return faller(Disc{radius}, position, mass, 0.5 * mass * radius * radius, material);
}

/// A floor, and unit boxes one on the other.
inline std::vector<RestBody> stack(int count, const Material& material = {0.0, 0.5})
{
    std::vector<RestBody> bodies = {wall(Vec2(0.0, 1.0), 0.0, material)};
    for (int k = 0; k < count; ++k) bodies.push_back(box(1.0, 1.0, Vec2(0.0, 0.5 + k), 1.0, material));
    return bodies;
}

/// Kinetic energy and that in the field.  [J]
inline double energy(const RestEngine& engine)
{
    double sum = 0.0;
    for (int k = 0; k < engine.body_count(); ++k) {
        const RestBody& body = engine.body(k);
        if (body.is_static) continue;
        const BodyState& s = body.state;
        const double mass = 1.0 / body.inertia.inv_mass;
        sum += 0.5 * mass * s.velocity.squaredNorm() + 0.5 * s.spin * s.spin / body.inertia.inv_moment_of_inertia;
        sum -= mass * body.acceleration.dot(s.position);
    }
    return sum;
}

/// A body on a slope that rises to the right: its place up the slope from where it began.  [m]
struct Slope
{
    double angle;
    Vec2 normal() const { return Vec2(-std::sin(angle), std::cos(angle)); }
    Vec2 up() const { return Vec2(std::cos(angle), std::sin(angle)); }
};

/// An engine with one body, its lower side on the slope, `height` from its centre.
inline RestEngine on_slope(const Slope& slope, RestBody body, double height, const RestOptions& options = {})
{
    body.state.position = height * slope.normal();
    body.state.angle = slope.angle;
    return RestEngine({wall(slope.normal(), 0.0, body.material), body}, options);
}

} // namespace flying::test
