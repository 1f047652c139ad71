#pragma once

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "collide/separation.hpp"
#include "rest/rest_engine.hpp"
#include "world/world.hpp"

/// How deep bodies have got into each other, as users are promised it: in sizes of the smaller one.
namespace flying::testing {

/// A body where it is.
struct Placed
{
    CollisionShape shape;
    double size = 0.0; ///< bounding radius; infinite for a wall [m]
    BodyState state;
    bool is_fixed = false;
};

inline Placed placed(const Shape& shape, const BodyState& state, bool is_fixed)
{
    return {make_collision_shape(shape), bounding_radius(shape), state, is_fixed};
}

/// Of any two of which one can move.  [bounding radii of the smaller one]
inline double deepest_overlap(const std::vector<Placed>& bodies)
{
    double deepest = 0.0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const Placed& a = bodies[k];
        for (std::size_t i = 0; i < k; ++i) {
            const Placed& b = bodies[i];
            if (a.is_fixed && b.is_fixed) continue;
            if ((a.state.position - b.state.position).norm() > a.size + b.size) continue;
            const double gap = separation(a.shape, pose_of(a.state), b.shape, pose_of(b.state));
            deepest = std::max(deepest, -gap / std::min(a.size, b.size));
        }
    }
    return deepest;
}

/// Of a world at its clock, its walls and the core of its field included.
inline double deepest_overlap(const World& world)
{
    std::vector<Placed> bodies;
    for (int k = 0; k < world.body_count(); ++k)
        bodies.push_back(placed(world.shape(k), world.state(k), world.is_static(k)));
    const WorldDef& around = world.scene().world;
    if (around.box) {
        const auto& [low, high] = *around.box;
        for (const HalfPlane& wall : {HalfPlane{{1.0, 0.0}, low.x()}, HalfPlane{{-1.0, 0.0}, -high.x()},
                                      HalfPlane{{0.0, 1.0}, low.y()}, HalfPlane{{0.0, -1.0}, -high.y()}})
            bodies.push_back(placed(wall, {}, true));
    }
    if (const auto* field = std::get_if<CentralField>(&around.field); field && field->radius > 0.0) {
        BodyState state;
        state.position = field->centre;
        bodies.push_back(placed(Disc{field->radius}, state, true));
    }
    return deepest_overlap(bodies);
}

/// Of the bodies that steps alone move.
inline double deepest_overlap(const RestEngine& engine)
{
    std::vector<Placed> bodies;
    for (int k = 0; k < engine.body_count(); ++k) {
        const RestBody& body = engine.body(k);
        bodies.push_back(placed(body.shape, engine.state(k), body.is_static));
    }
    return deepest_overlap(bodies);
}

} // namespace flying::testing
