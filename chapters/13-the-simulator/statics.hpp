#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "mass/polygon.hpp"
#include "rest/rest_engine.hpp"
#include "gallery.hpp"
#include "world/make_shape.hpp"

/// What statics says of the scenes that people try, worked out without the engine.
namespace flying::statics {

/// Area and first moment of a polygon.
struct Weight
{
    double area = 0.0;
    double moment = 0.0; ///< of x over the area
};

inline Weight weight_of(const std::vector<Vec2>& ring)
{
    Weight weight;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2& p = ring[k];
        const Vec2& q = ring[(k + 1) % ring.size()];
        weight.area += 0.5 * cross(p, q);
        weight.moment += cross(p, q) * (p.x() + q.x()) / 6.0;
    }
    return weight;
}

/// Whether some line of thrust stays within a half circle of wedges, and leans at each joint by no more than friction
/// allows. Unknown are the thrust H at the crown and its moment M; each joint gives two bounds of M that are linear in H,
/// and the room between the largest lower and the least upper one is concave in H.
/// stones     odd
/// thickness  [mean radii]
inline bool arch_can_stand(int stones, double thickness, double friction)
{
    struct Joint
    {
        Vec2 inner = Vec2::Zero();
        Vec2 outer = Vec2::Zero();
        Weight above; ///< of all from the crown to here
    };
    const auto joint_at = [&](int k) {
        const double angle = std::numbers::pi * k / stones;
        const Vec2 out(std::cos(angle), std::sin(angle));
        return Joint{(1.0 - 0.5 * thickness) * out, (1.0 + 0.5 * thickness) * out, {}};
    };
    std::vector<Joint> joints;
    double least = 0.0; // thrust
    double most = std::numeric_limits<double>::infinity();
    for (int k = stones / 2; k >= 0; --k) {
        Joint joint = joint_at(k);
        const Joint before = joints.empty() ? Joint{{0.0, joint.inner.y()}, {0.0, joint.outer.y()}, {}} : joints.back();
        const Weight stone = weight_of({joint.inner, joint.outer, before.outer, before.inner});
        joint.above = {before.above.area + stone.area, before.above.moment + stone.moment};
        joints.push_back(joint);

        // |T| <= friction N with  T = W sin - H cos,  N = H sin + W cos
        const Vec2 along = joint.outer.normalized();
        const double w = joint.above.area;
        least = std::max(least, w * (along.y() - friction * along.x()) / (along.x() + friction * along.y()));
        const double holds = along.x() - friction * along.y();
        if (holds > 0.0) most = std::min(most, w * (along.y() + friction * along.x()) / holds);
    }
    most = std::min(most, 100.0 * joints.back().above.area);
    const auto room = [&](double thrust) {
        double low = -std::numeric_limits<double>::infinity();
        double high = std::numeric_limits<double>::infinity();
        for (const Joint& joint : joints) {
            const auto moment = [&](const Vec2& at) {
                return at.y() * thrust - (joint.above.moment - at.x() * joint.above.area);
            };
            low = std::max(low, moment(joint.inner));
            high = std::min(high, moment(joint.outer));
        }
        return high - low;
    };
    for (int k = 0; k < 100; ++k) {
        const double one = least + (most - least) / 3.0;
        const double two = most - (most - least) / 3.0;
        (room(one) < room(two) ? least : most) = room(one) < room(two) ? one : two;
    }
    return room(0.5 * (least + most)) >= 0.0;
}

/// The thinnest half circle of wedges that can stand.  [mean radii]
inline double thinnest_arch(int stones, double friction)
{
    double falls = 0.01;
    double stands = 1.0;
    for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (falls + stands);
        (arch_can_stand(stones, middle, friction) ? stands : falls) = middle;
    }
    return stands;
}

/// The least friction with which the lowest cards of a house of one or two levels can stand. A card pivots on the inner
/// end of its foot and on the end of its head, where its partner pushes; what lies on it presses on the other end of its
/// head. Moments about where the two meet:  F h = N a - w b - Q c.
inline double least_friction(const gallery::Cards& house)
{
    const std::vector<Vec2> card = gallery::left_card(house);
    const Weight own = weight_of(card);
    const double middle = card[3].x();
    double on_top = 0.0; // of one card's head
    if (house.levels == 2) {
        const double pitch = 2.0 * middle + 2.0 * house.thickness;
        on_top = 0.25 * ((pitch + 0.5 * house.height) * house.thickness + 2.0 * own.area);
    }
    const double foot = own.area + on_top;
    const double push = foot * (middle - card[1].x()) - (middle * own.area - own.moment) - on_top * (middle - card[4].x());
    return push / house.height / foot;
}

/// The bodies of a scene in the resting integrator alone.
inline RestEngine resting(const Scene& scene)
{
    std::vector<RestBody> bodies;
    for (const BodyDef& def : scene.bodies) {
        const Shape shape = make_shape(def.shape).value();
        const MassProperties mass = mass_of(shape, def.density.value_or(1.0));
        RestBody body{shape, {}, {}, {scene.world.restitution, scene.world.friction}};
        body.state.position = def.position;
        body.state.angle = def.angle;
        body.is_static = def.is_static;
        if (!def.is_static) {
            body.inertia = {1.0 / mass.mass, 1.0 / mass.moment_of_inertia};
            body.acceleration = uniform_acceleration(scene.world.field);
        }
        bodies.push_back(std::move(body));
    }
    return RestEngine(std::move(bodies));
}

} // namespace flying::statics
