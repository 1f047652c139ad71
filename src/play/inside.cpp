#include "play/inside.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "broadphase/grid.hpp"
#include "collide/manifold.hpp"
#include "mass/polygon.hpp"
#include "toi/predict.hpp"
#include "world/memory.hpp"
#include "world/plan.hpp"

namespace flying {

namespace {

constexpr double k_touching = 0.1; ///< [sizes] a contact of the last step isn't farther away

/// Shapes of what stands around: the walls, then the core.
std::vector<Shape> surrounding_shapes(const WorldDef& world)
{
    std::vector<Shape> all;
    if (world.box) {
        all = {HalfPlane{Vec2(1.0, 0.0), world.box->min.x()}, HalfPlane{Vec2(-1.0, 0.0), -world.box->max.x()},
               HalfPlane{Vec2(0.0, 1.0), world.box->min.y()}, HalfPlane{Vec2(0.0, -1.0), -world.box->max.y()}};
    }
    const auto* central = std::get_if<CentralField>(&world.field);
    if (central && central->radius > 0.0) all.push_back(Disc{central->radius});
    return all;
}

/// As the world weighs it.
Inertia weigh(const BodyDef& def, const Shape& shape)
{
    if (def.is_static) return {};
    const MassProperties at_unit_density = mass_of(shape, 1.0);
    const double density = def.mass ? *def.mass / at_unit_density.mass : def.density.value_or(1.0);
    const double mass = def.mass ? *def.mass : at_unit_density.mass * density;
    return {1.0 / mass, 1.0 / (at_unit_density.moment_of_inertia * density)};
}

bool flies(const World& world, int body)
{
    return body < world.body_count() && world.mover(body) == World::Mover::events;
}

/// Cells as the event engine lays them out when it begins.
double cell_size_of(const World& world, const Inside& inside)
{
    const bool is_central = std::holds_alternative<CentralField>(world.scene().world.field);
    if (is_central || make_plan(world.scene()).pair_finder != PairFinder::grid) return 0.0;
    double largest = 0.0;
    int movers = 0;
    const double infinite = std::numeric_limits<double>::infinity();
    Aabb extent{Vec2::Constant(infinite), Vec2::Constant(-infinite)};
    for (int k = 0; k < world.body_count(); ++k) {
        if (!flies(world, k)) continue;
        const Vec2 here = world.state(k).position;
        largest = std::max(largest, bounding_radius(world.shape(k)));
        extent.min = extent.min.cwiseMin(here);
        extent.max = extent.max.cwiseMax(here);
        ++movers;
    }
    if (movers == 0) return 0.0;
    return make_grid(extent, largest, static_cast<int>(inside.shapes.size()), movers).cell_size();
}

Flyer flyer_of(const World& world, int body)
{
    const WorldDef& around = world.scene().world;
    Flyer flyer;
    if (body >= world.body_count()) {
        if (const auto* central = std::get_if<CentralField>(&around.field)) flyer.state.position = central->centre;
        flyer.state.time = world.time();
        return flyer;
    }
    flyer.state = world.state(body);
    flyer.state.time = world.time();
    if (!flies(world, body)) {
        flyer.state.velocity = Vec2::Zero();
        flyer.state.spin = 0.0;
        return flyer;
    }
    flyer.acceleration = uniform_acceleration(around.field);
    flyer.central = std::get_if<CentralField>(&around.field);
    return flyer;
}

/// How far a body that flies may get within that time.  [m]
double reach_of(const Flyer& flyer, const World& world, double within)
{
    const double pull = acceleration_at(world.scene().world.field, flyer.state.position).norm();
    return within * (flyer.state.velocity.norm() + 0.5 * within * pull);
}

} // namespace

std::vector<Inertia> weigh_all(const World& world)
{
    std::vector<Inertia> all;
    for (int k = 0; k < world.body_count(); ++k) {
        all.push_back(weigh(world.scene().bodies[static_cast<std::size_t>(k)], world.shape(k)));
    }
    return all;
}

Inside look_inside(const World& world)
{
    Inside inside;
    for (int k = 0; k < world.body_count(); ++k) {
        inside.shapes.push_back(make_collision_shape(world.shape(k)));
    }
    for (const Shape& shape : surrounding_shapes(world.scene().world))
        inside.shapes.push_back(make_collision_shape(shape));
    inside.cell_size = cell_size_of(world, inside);
    return inside;
}

std::vector<LeaningContact> leaning_contacts(const World& world, const Inside& inside, double step)
{
    std::vector<LeaningContact> contacts;
    const Snapshot snapshot = world.snapshot();
    const std::optional<RestEngine::Memory>& memory = snapshot.engines->hybrid.resting;
    if (!memory) return contacts;
    for (const RestPair& pair : memory->pairs) {
        if (pair.count == 0) continue;
        const std::size_t place_a = static_cast<std::size_t>(pair.a);
        const std::size_t place_b = static_cast<std::size_t>(pair.b);
        if (!memory->bodies[place_a].is_active || !memory->bodies[place_b].is_active) continue;
        const int a = memory->order[place_a];
        const int b = memory->order[place_b];
        const ConvexPart& part_a =
            inside.shapes[static_cast<std::size_t>(a)].parts[static_cast<std::size_t>(pair.part_a)];
        const ConvexPart& part_b =
            inside.shapes[static_cast<std::size_t>(b)].parts[static_cast<std::size_t>(pair.part_b)];
        const double margin = k_touching * std::min(part_a.radius, part_b.radius);
        const Manifold manifold = make_manifold(part_a.shape, pose_of(memory->bodies[place_a].state), part_b.shape,
                                                pose_of(memory->bodies[place_b].state), margin);
        for (int k = 0; k < pair.count; ++k) {
            for (int i = 0; i < manifold.count; ++i) {
                const Contact& contact = manifold.contacts[i];
                if (contact.feature != pair.feature[k]) continue;
                contacts.push_back(
                    {a, b, contact.point, contact.normal, pair.normal[k] / step, pair.tangent[k] / step});
            }
        }
    }
    return contacts;
}

std::vector<int> islands(const World& world, const std::vector<LeaningContact>& contacts)
{
    const int count = world.body_count();
    std::vector<int> group(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) group[static_cast<std::size_t>(k)] = k;
    const auto root = [&](int k) {
        while (group[static_cast<std::size_t>(k)] != k) k = group[static_cast<std::size_t>(k)];
        return k;
    };
    const auto leans = [&](int k) {
        return k < count && (world.mover(k) == World::Mover::rest || world.mover(k) == World::Mover::asleep);
    };
    for (const LeaningContact& contact : contacts) {
        if (!leans(contact.a) || !leans(contact.b) || contact.normal_force == 0.0) continue;
        const int one = root(contact.a);
        const int two = root(contact.b);
        group[static_cast<std::size_t>(std::max(one, two))] = std::min(one, two);
    }
    for (int k = 0; k < count; ++k) group[static_cast<std::size_t>(k)] = leans(k) ? root(k) : -1;
    return group;
}

std::vector<NextImpact> next_impacts(const World& world, const Inside& inside, std::size_t most, double within)
{
    const int all = static_cast<int>(inside.shapes.size());
    std::vector<Flyer> flyers;
    for (int k = 0; k < all; ++k) flyers.push_back(flyer_of(world, k));
    const std::vector<Shape> around = surrounding_shapes(world.scene().world);
    const auto shape_of = [&](int k) -> const Shape& {
        return k < world.body_count() ? world.shape(k) : around[static_cast<std::size_t>(k - world.body_count())];
    };

    // How far from where it is each may be met: asked once for each, not for each pair
    struct Around
    {
        Vec2 place = Vec2::Zero();
        double reach = 0.0;
        bool flies = false;
    };
    std::vector<Around> arounds;
    for (int k = 0; k < all; ++k) {
        const Flyer& flyer = flyers[static_cast<std::size_t>(k)];
        const bool is_flyer = flies(world, k);
        arounds.push_back({flyer.state.position,
                           bounding_radius(shape_of(k)) + (is_flyer ? reach_of(flyer, world, within) : 0.0), is_flyer});
    }

    // Of pairs that may come together in time
    const double now = world.time();
    std::vector<NextImpact> impacts;
    for (int a = 0; a < world.body_count(); ++a) {
        const Around& around_a = arounds[static_cast<std::size_t>(a)];
        if (!around_a.flies) continue;
        const Flyer& flyer_a = flyers[static_cast<std::size_t>(a)];
        for (int b = 0; b < all; ++b) {
            const Around& around_b = arounds[static_cast<std::size_t>(b)];
            if (b == a || (around_b.flies && b < a)) continue;
            const double reach = around_a.reach + around_b.reach; // infinite for walls
            if ((around_a.place - around_b.place).squaredNorm() > reach * reach) continue;
            const auto* wall = std::get_if<HalfPlane>(&shape_of(b));
            if (wall && wall->normal.dot(around_a.place) - wall->offset > around_a.reach) continue;
            const Flyer& flyer_b = flyers[static_cast<std::size_t>(b)];
            const Prediction next = predict(world.shape(a), flyer_a, shape_of(b), flyer_b, now);
            if (next.kind != Prediction::Kind::impact || next.time > now + within) continue;
            impacts.push_back(
                {next.time, a, b, state_at(flyer_a, next.time).position, state_at(flyer_b, next.time).position});
        }
    }
    std::sort(impacts.begin(), impacts.end(), [](const NextImpact& p, const NextImpact& q) {
        return std::tie(p.time, p.a, p.b) < std::tie(q.time, q.a, q.b);
    });

    // What comes after a body's first impact will be another
    std::vector<char> met(static_cast<std::size_t>(all), 0);
    std::vector<NextImpact> first;
    for (const NextImpact& impact : impacts) {
        char& met_a = met[static_cast<std::size_t>(impact.a)];
        char& met_b = met[static_cast<std::size_t>(impact.b)];
        if (met_a || met_b || first.size() == most) continue;
        met_a = 1;
        met_b = flies(world, impact.b) ? 1 : 0;
        first.push_back(impact);
    }
    return first;
}

} // namespace flying
