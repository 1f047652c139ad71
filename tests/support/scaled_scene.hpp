#pragma once

#include <variant>

#include "world/scene.hpp"

/// A scene in other units: where these are powers of two, its run has the same bits but for the exponents.
namespace flying::testing {

/// The units of a scene in those of another.
struct Units
{
    double length = 1.0;
    double time = 1.0;
    double density = 1.0; ///< of all bodies
};

inline void in_length(ShapeDef& shape, double length)
{
    if (auto* disc = std::get_if<DiscDef>(&shape)) disc->radius *= length;
    if (auto* regular = std::get_if<RegularDef>(&shape)) regular->radius *= length;
    if (auto* square = std::get_if<SquareDef>(&shape)) square->side *= length;
    if (auto* rectangle = std::get_if<RectangleDef>(&shape)) {
        rectangle->width *= length;
        rectangle->height *= length;
    }
    if (auto* triangle = std::get_if<TriangleDef>(&shape)) {
        for (double& side : triangle->sides) side *= length;
    }
    if (auto* polygon = std::get_if<PolygonDef>(&shape)) {
        for (Vec2& vertex : polygon->vertices) vertex *= length;
        for (auto& hole : polygon->holes) {
            for (Vec2& vertex : hole) vertex *= length;
        }
    }
}

[[nodiscard]] inline Scene in_units(Scene scene, const Units& units)
{
    const double speed = units.length / units.time;
    if (auto* field = std::get_if<UniformField>(&scene.world.field)) field->gravity *= speed / units.time;
    if (auto* field = std::get_if<CentralField>(&scene.world.field)) {
        field->centre *= units.length;
        field->radius *= units.length;
        field->mu *= units.length * speed * speed;
    }
    if (scene.world.box) {
        scene.world.box->min *= units.length;
        scene.world.box->max *= units.length;
    }
    scene.until *= units.time;
    for (BodyDef& body : scene.bodies) {
        in_length(body.shape, units.length);
        body.position *= units.length;
        body.velocity *= speed;
        body.spin /= units.time;
        if (body.mass) *body.mass *= units.density * units.length * units.length;
        else if (!body.is_static) body.density = units.density * body.density.value_or(1.0);
    }
    return scene;
}

} // namespace flying::testing
