#include "world/make_room.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "collide/manifold.hpp"
#include "world/make_shape.hpp"
#include "world/start_overlaps.hpp"

namespace flying {

namespace {

constexpr int k_rounds = 60;
/// Arches of typed stones and houses of cards take a thousand rounds; in all [bodies].
constexpr int k_most_rounds = 2000;
constexpr std::size_t k_most_work = 200000;
constexpr std::size_t k_most_pairs = 20000;
/// [bounding radii] How far digits that a file leaves out may have put a body: five after the point are what people
/// type, and in a column of bodies they add up.
constexpr double k_typed = 1e-4;
/// [depths] Pushed a little farther than needed, so that rounds end.
constexpr double k_more = 1.02;

struct Deepest
{
    double depth = 0.0;
    Vec2 normal = Vec2::Zero(); ///< from the first to the second
};

/// The deepest contact among the parts of two bodies; none where they don't overlap.
std::optional<Deepest> deepest(const PlacedBody& a, const PlacedBody& b)
{
    std::optional<Deepest> found;
    for (const ConvexPart& part_a : a.shape.parts) {
        for (const ConvexPart& part_b : b.shape.parts) {
            const Manifold manifold = make_manifold(part_a.shape, a.pose, part_b.shape, b.pose, 0.0);
            for (int k = 0; k < manifold.count; ++k) {
                const double depth = -manifold.contacts[k].separation;
                if (depth > 0.0 && (!found || depth > found->depth)) found = Deepest{depth, manifold.contacts[k].normal};
            }
        }
    }
    return found;
}

/// The box's walls and the core, as bodies that nothing moves.
std::vector<PlacedBody> surroundings(const WorldDef& world)
{
    std::vector<PlacedBody> all;
    const auto add = [&](Shape shape, const Vec2& place, double size) {
        PlacedBody body;
        body.is_static = true;
        body.pose.position = place;
        body.size = size;
        body.shape = make_collision_shape(shape);
        all.push_back(std::move(body));
    };
    const double infinite = std::numeric_limits<double>::infinity();
    if (world.box) {
        add(HalfPlane{Vec2(1.0, 0.0), world.box->min.x()}, Vec2::Zero(), infinite);
        add(HalfPlane{Vec2(-1.0, 0.0), -world.box->max.x()}, Vec2::Zero(), infinite);
        add(HalfPlane{Vec2(0.0, 1.0), world.box->min.y()}, Vec2::Zero(), infinite);
        add(HalfPlane{Vec2(0.0, -1.0), -world.box->max.y()}, Vec2::Zero(), infinite);
    }
    const auto* central = std::get_if<CentralField>(&world.field);
    if (central && central->radius > 0.0) add(Disc{central->radius}, central->centre, central->radius);
    return all;
}

std::vector<PlacedBody> place(const Scene& scene)
{
    std::vector<PlacedBody> placed;
    for (int k = 0; k < static_cast<int>(scene.bodies.size()); ++k) {
        const BodyDef& def = scene.bodies[k];
        Expected<Shape> shape = make_shape(def.shape);
        if (!shape) continue;
        PlacedBody body;
        body.index = k;
        body.is_static = def.is_static;
        body.pose = {def.position, Rotation::of(def.angle)};
        body.size = bounding_radius(shape.value());
        body.shape = make_collision_shape(shape.value());
        placed.push_back(std::move(body));
    }
    return placed;
}

} // namespace

bool make_room(Scene& scene, double most)
{
    const std::size_t affordable = k_most_work / std::max<std::size_t>(scene.bodies.size(), 1);
    const int rounds = std::clamp(static_cast<int>(affordable), k_rounds, k_most_rounds);
    std::vector<PlacedBody> bodies = place(scene);
    const std::vector<PlacedBody> around = surroundings(scene.world);
    std::vector<int> by_index(scene.bodies.size(), -1);
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i) by_index[bodies[i].index] = i;

    bool is_free = false;
    for (int round = 0; round < rounds && !is_free; ++round) {
        is_free = true;

        // Between bodies: both give way, unless one is static
        for (PlacedBody& body : bodies) {
            const Vec2 reach(body.size, body.size);
            body.box = {body.pose.position - reach, body.pose.position + reach};
        }
        for (const StartOverlap& pair : find_start_overlaps(bodies, k_most_pairs)) {
            PlacedBody& a = bodies[by_index[pair.first]];
            PlacedBody& b = bodies[by_index[pair.second]];
            is_free = false;
            const std::optional<Deepest> touch = deepest(a, b);
            if (!touch) continue;
            const double share_a = a.is_static ? 0.0 : b.is_static ? 1.0 : 0.5;
            const Vec2 way = k_more * touch->depth * touch->normal;
            a.pose.position -= share_a * way;
            b.pose.position += (1.0 - share_a) * way;
        }

        // And away from what is around all
        for (PlacedBody& body : bodies) {
            if (body.is_static) continue;
            for (const PlacedBody& thing : around) {
                const std::optional<Deepest> touch = deepest(thing, body);
                const double reach = body.pose.position.norm() + body.size;
                if (!touch || touch->depth <= 0.5 * start_overlap_allowed(body.size, reach)) continue;
                is_free = false;
                // To the exact place first: a body that leans on a wall stays on it
                const double farther = round < rounds / 2 ? 1.0 : k_more;
                body.pose.position += farther * touch->depth * touch->normal;
            }
        }

        for (const PlacedBody& body : bodies) {
            const Vec2& start = scene.bodies[body.index].position;
            if (!((body.pose.position - start).norm() <= most * body.size)) return false;
        }
    }
    if (!is_free) return false;
    for (const PlacedBody& body : bodies) {
        scene.bodies[body.index].position = body.pose.position;
    }
    return true;
}

bool make_room_for_digits(Scene& scene)
{
    Scene roomy = scene;
    if (!make_room(roomy, k_typed) || !validate(roomy).empty()) return false;
    scene = std::move(roomy);
    return true;
}

} // namespace flying
