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

} // namespace flying::testing
