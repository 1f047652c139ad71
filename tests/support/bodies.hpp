#pragma once

#include "world/scene.hpp"

/// Bodies of scenes that tests of several folders make alike.
namespace flying::testing {

inline BodyDef disc(double radius, const Vec2& position, const Vec2& velocity = Vec2::Zero())
{
    BodyDef body;
    body.shape = DiscDef{radius};
    body.position = position;
    body.velocity = velocity;
    return body;
}

inline BodyDef rectangle(double width, double height, const Vec2& position, const Vec2& velocity = Vec2::Zero())
{
    BodyDef body;
    body.shape = RectangleDef{width, height};
    body.position = position;
    body.velocity = velocity;
    return body;
}

inline BodyDef still(BodyDef body)
{
    body.is_static = true;
    return body;
}

/// A world with nothing in it but a field of 9.81 m/s^2 downwards, and a floor of 400 m whose top is at height 0.
inline Scene on_a_floor(double restitution, double friction)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    scene.bodies.push_back(still(rectangle(400.0, 1.0, {0.0, -0.5})));
    return scene;
}

} // namespace flying::testing
