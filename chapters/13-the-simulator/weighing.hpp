#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "../04-arbitrary-polygon/wrong_polygon.hpp"
#include "events/event_engine.hpp"
#include "world/make_shape.hpp"
#include "world/scene.hpp"

// The same scene with bodies weighed in two ways.
namespace flying {

enum class Scales
{
    right,
    original
};

/// Area, centre and second moment of a shape: as they are, or as the original had them.
/// Its rectangles and regular polygons were right; any other shape it cut into triangles
/// about the mean of the corners, and gave each a positive area.
inline AreaMoments moments_by(Scales scales, const ShapeDef& def, const Polygon& polygon)
{
    const bool is_any = std::holds_alternative<PolygonDef>(def);
    if (scales == Scales::right || !is_any) return moments_of(polygon);
    return moments_without_sign(polygon.vertices());
}

/// The bodies of a scene of polygons, without walls.
inline std::vector<EventBody> weigh(const Scene& scene, Scales scales)
{
    std::vector<EventBody> bodies;
    const Material smooth{scene.world.restitution, scene.world.friction};
    for (const BodyDef& def : scene.bodies) {
        const Shape made = make_shape(def.shape).value();
        const Polygon polygon = std::get<Polygon>(made);
        const AreaMoments m = moments_by(scales, def.shape, polygon);
        const bool is_right = scales == Scales::right; // then its centre is the origin
        const Polygon about_centre = is_right ? polygon : polygon.moved_by(-m.centroid);
        EventBody body{about_centre, {}, {}, smooth, def.is_static};
        body.flyer.state = {def.position, def.velocity, def.angle, def.spin, 0.0};
        if (!def.is_static) {
            const double density = def.density.value_or(1.0);
            body.inertia = {1.0 / (density * m.area), 1.0 / (density * m.second_moment)};
            body.flyer.acceleration = uniform_acceleration(scene.world.field);
        }
        bodies.push_back(std::move(body));
    }
    return bodies;
}

/// The same, and the four walls of its box.
inline std::vector<EventBody> weigh_in_box(const Scene& scene, Scales scales)
{
    std::vector<EventBody> bodies = weigh(scene, scales);
    const BoxDef& box = *scene.world.box;
    const Material smooth{scene.world.restitution, scene.world.friction};
    const HalfPlane walls[] = {
        {{1.0, 0.0}, box.min.x()}, {{-1.0, 0.0}, -box.max.x()}, {{0.0, 1.0}, box.min.y()}, {{0.0, -1.0}, -box.max.y()}};
    for (const HalfPlane& wall : walls) bodies.push_back({wall, {}, {}, smooth, true});
    return bodies;
}

/// An impact: when, and of which two.
struct Meeting
{
    double time = 0.0; ///< [s]
    int a = -1;
    int b = -1;
};

/// The impacts of a run, one by one.
inline std::vector<Meeting> meetings_of(EventEngine& engine, double until)
{
    std::vector<Meeting> meetings;
    while (engine.time() < until) {
        const std::int64_t before = engine.counts().impacts;
        if (engine.advance(until, 1)) break;
        if (engine.counts().impacts == before) continue;
        const Event& impact = engine.last_impacts().back();
        meetings.push_back({impact.time, impact.a, impact.b});
    }
    return meetings;
}

/// Kinetic energy with the masses that the bodies were given.  [J]
inline double kinetic_energy(const EventEngine& engine)
{
    double sum = 0.0;
    for (int k = 0; k < engine.body_count(); ++k) {
        const Inertia& inertia = engine.inertia(k);
        if (inertia.inv_mass == 0.0) continue;
        const BodyState& state = engine.flyer(k).state;
        sum += 0.5 * state.velocity.squaredNorm() / inertia.inv_mass;
        sum += 0.5 * state.spin * state.spin / inertia.inv_moment_of_inertia;
    }
    return sum;
}

} // namespace flying
