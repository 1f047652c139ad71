#pragma once

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "geometry/shape.hpp"
#include "rest/find_contacts.hpp"
#include "rest/islands.hpp"
#include "rest/step_field.hpp"

/// Bodies and the data of a step, made by hand.
namespace flying::testing {

inline constexpr double k_g = 10.0; // [m/s^2]

/// A unit box of 1 kg.
inline RestBody box_at(const Vec2& position, const Vec2& velocity = Vec2::Zero(), double spin = 0.0)
{
    const Polygon box({{Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.5, 0.5), Vec2(-0.5, 0.5)}});
    RestBody body{box, {}, {1.0, 6.0}, {0.0, 0.5}};
    body.state.position = position;
    body.state.velocity = velocity;
    body.state.spin = spin;
    body.acceleration = Vec2(0.0, -k_g);
    return body;
}

inline RestBody ground()
{
    RestBody body{HalfPlane{Vec2(0.0, 1.0), 0.0}, {}, {}, {0.0, 0.5}};
    body.is_static = true;
    return body;
}

/// As a step begins: reaches, pairs, and what the field will do.
inline RestData data_of(std::vector<RestBody> bodies, const RestOptions& options = {})
{
    std::vector<int> order(bodies.size());
    std::iota(order.begin(), order.end(), 0);
    RestData data(options, RestBodies(std::move(bodies), std::move(order), 0.0));
    for (int k = 0; k < data.bodies.count(); ++k) {
        const RestBody& body = data.bodies.list[k];
        expect_flight(data, k, body.state.position);
        const double dt = data.motion.span;
        if (!body.is_static) data.motion.reach[k] = dt * (body.state.velocity.norm() + dt * k_g) + 0.01;
    }
    BodySet awake(data.bodies.count());
    for (int k = 0; k < data.bodies.count(); ++k) {
        if (!data.bodies.list[k].is_static) awake.insert(k);
    }
    data.pairs.update(data.bodies, {data.motion.reach, data.motion.reach}, awake);
    return data;
}

inline std::vector<ContactPoint> contacts_of(RestData& data)
{
    std::vector<ContactPoint> found;
    for (int k = 0; k < static_cast<int>(data.pairs.pairs().size()); ++k) (void)find_contacts(data, k, found);
    return found;
}

inline std::vector<int> moved_in(const RestData& data)
{
    std::vector<int> moved;
    for (int k = 0; k < data.bodies.count(); ++k) {
        if (data.motion.is_moved(k)) moved.push_back(k);
    }
    return moved;
}

} // namespace flying::testing
