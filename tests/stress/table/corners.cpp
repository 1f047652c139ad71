// Corners that rounding could catch: seams between tiles, low steps, notches where friction cones meet, knife edges.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "math/random.hpp"
#include "math/rotation.hpp"
#include "math/vec2.hpp"
#include "table/trials.hpp"

namespace flying::stress {
namespace {

constexpr double k_tiles_begin = -2.0; // [m]
constexpr double k_tiles_length = 40.0;

/// A floor of tiles laid flush, or of one slab as long.
struct Floor
{
    double tile = 1.0;  ///< width of a tile [m]
    double slope = 0.0; ///< [rad]
    bool is_slab = false;
    bool is_polygon = false; ///< tiles given by corners about an origin of their own, so that rounding is different
};

void lay(Scene& scene, const Floor& floor)
{
    constexpr double k_height = 0.3;
    const double width = floor.is_slab ? k_tiles_length : floor.tile;
    const auto count = static_cast<int>(k_tiles_length / width + 1e-9);
    for (int k = 0; k < count; ++k) {
        BodyDef tile = rectangle(width, k_height,
                                 Rotation::of(floor.slope) * Vec2(k_tiles_begin + (k + 0.5) * width, -0.5 * k_height));
        if (floor.is_polygon && !floor.is_slab)
            tile.shape =
                PolygonDef{{{0.1, 0.2}, {0.1 + width, 0.2}, {0.1 + width, 0.2 + k_height}, {0.1, 0.2 + k_height}}, {}};
        tile.angle = floor.slope;
        scene.bodies.push_back(still(tile));
    }
}

/// A box or a polygon with a side on the floor, on its way along it.
BodyDef slider(Random& random, double slope)
{
    const int sides[] = {4, 4, 5, 6, 8};
    const int corners = sides[random.below(5)];
    const double size = random.uniform(0.2, 0.7);
    const double x = random.uniform(0.0, 2.0);
    const Rotation turned = Rotation::of(slope);
    BodyDef body = rectangle(2.0 * size, size, turned * Vec2(x, 0.5 * size));
    body.angle = slope;
    if (corners != 4) {
        body.shape = RegularDef{corners, size};
        body.position = turned * Vec2(x, size * std::cos(std::numbers::pi / corners));
        body.angle -= std::numbers::pi / 2.0 + std::numbers::pi / corners;
    }
    body.velocity = turned * Vec2(random.uniform(0.5, 15.0), 0.0);
    return body;
}

Reached flush_tiles(const Share&)
{
    Reached reached;
    Random random(21);
    constexpr int k_sliders = 300;
    for (int k = 0; k < k_sliders; ++k) {
        const double tiles[] = {0.25, 1.0 / 3.0, 0.37, 0.5, 1.0, 2.0};
        Floor floor;
        floor.tile = tiles[random.below(6)];
        floor.slope = k % 3 == 0 ? random.uniform(-0.3, 0.3) : 0.0;
        floor.is_polygon = k % 5 == 0;
        const BodyDef body = slider(random, floor.slope);
        Scene scene;
        scene.world.field = UniformField{{0.0, -k_gravity}};
        scene.world.restitution = std::array{0.0, 0.3, 0.5, 0.9, 1.0}[static_cast<std::size_t>(random.below(5))];
        // With more a polygon tips over, and the least difference grows
        const double most = std::holds_alternative<RectangleDef>(body.shape) ? 0.9 : 0.3;
        scene.world.friction = k % 2 == 0 ? 0.0 : random.uniform(0.1, most);
        WorldOptions options;
        if (k % 6 == 0) options.engine = EngineChoice::rest;
        Vec2 end[2];
        for (const bool is_slab : {false, true}) {
            floor.is_slab = is_slab;
            Scene laid = scene;
            lay(laid, floor);
            laid.bodies.push_back(body);
            World world = world_of(laid, options);
            run_to(world, 1.5);
            end[is_slab ? 1 : 0] = world.state(static_cast<int>(laid.bodies.size()) - 1).position;
        }
        const double off = (end[0] - end[1]).norm();
        if (off > reached.value) reached.remark = fmt::format("most by number {}", k);
        reached.value = std::max(reached.value, off);
    }
    reached.amount =
        fmt::format("{} boxes and polygons over tiles of 0.25 to 2 m, slopes to 0.3, up to 15 m/s", k_sliders);
    return reached;
}

Reached low_step(const Share&)
{
    // They slide until they are at the step; no foot may go on from there at half its speed or more
    Reached reached;
    reached.value = 1.0;
    constexpr int k_boxes = 40;
    for (const double height : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
        bool all_trip = true;
        Random random(210);
        for (int k = 0; k < k_boxes; ++k) {
            Scene scene;
            scene.world.field = UniformField{{0.0, -k_gravity}};
            scene.world.restitution = k % 2 == 0 ? 0.0 : random.uniform(0.1, 0.9);
            scene.world.friction = k % 4 < 2 ? 0.0 : 0.2;
            Floor floor;
            floor.tile = k % 3 == 0 ? 0.5 : 1.0;
            lay(scene, floor);
            std::erase_if(scene.bodies, [](const BodyDef& tile) { return tile.position.x() > 4.0; });
            scene.bodies.push_back(still(rectangle(10.0, 0.3, {9.0, height - 0.15})));
            const double width = random.uniform(0.4, 1.4);
            const double tall = random.uniform(0.2, 0.6);
            const double speed = random.uniform(5.0, 15.0);
            scene.bodies.push_back(rectangle(width, tall, {random.uniform(0.0, 2.0), 0.5 * tall}, {speed, 0.0}));
            World world = world_of(scene);
            const int box = world.body_count() - 1;
            // As long as it goes on as it was, it has not met the step
            const double way = 4.0 - 0.5 * width - scene.bodies.back().position.x();
            const double braking = k_gravity * scene.world.friction;
            const double there = 2.0 * way / (speed + std::sqrt(speed * speed - 2.0 * braking * way));
            run_to(world, there + 1e-3);
            const BodyState state = world.state(box);
            const double foot =
                state.velocity.x() + state.spin * 0.5 * tall; // of the middle of its lower side, to first order
            all_trip = all_trip && foot < 0.5 * (speed - braking * there);
        }
        if (!all_trip) break;
        reached.value = height;
    }
    reached.amount = fmt::format("{} boxes of 0.2 to 1.4 m against each of seven steps, 5 to 15 m/s", k_boxes);
    return reached;
}

/// A disc that spins between two planes, left and right of it, each so much steeper than level; both contacts slip.
struct Groove
{
    double left = 0.5;  ///< [rad]
    double right = 0.5; ///< [rad]
    double mu = 0.5;
    double radius = 0.3; ///< [m]
    double spin = 40.0;  ///< counter-clockwise [rad/s]
};

struct Pushes
{
    double left = 0.0; ///< over the weight, as `right`
    double right = 0.0;
};

/// Two equations for two forces: pushes along the normals, friction against the spin, together the weight.
Pushes pushes_in(const Groove& groove)
{
    const double sign = groove.spin > 0.0 ? 1.0 : -1.0;
    const auto force = [&](const Vec2& normal) -> Vec2 {
        return normal + sign * groove.mu * Vec2(-normal.y(), normal.x());
    };
    const Vec2 a = force({std::sin(groove.left), std::cos(groove.left)});
    const Vec2 b = force({-std::sin(groove.right), std::cos(groove.right)});
    // left a + right b = (0, 1)
    const double all = cross(a, b);
    return {-b.x() / all, a.x() / all};
}

/// Pressed together, its two contacts alone could hold the disc, however it spins: the line between them lies in both
/// cones of friction. Coulomb's law then allows two answers.
bool may_wedge(const Groove& groove)
{
    const double off_normal = 0.5 * (std::numbers::pi - groove.left - groove.right); // angle to that line [rad]
    return std::tan(off_normal) <= groove.mu;
}

double off_in(const Groove& groove, const Pushes& pushes)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -k_gravity}};
    scene.world.restitution = 0.0;
    scene.world.friction = groove.mu;
    for (const bool is_left : {true, false}) {
        // A slab whose upper side is the plane; its place is that of the foot of the disc's centre on it
        const double lean = is_left ? -groove.left : groove.right;
        const Rotation turned = Rotation::of(lean);
        BodyDef plane = rectangle(4.0 * groove.radius, 1.0, turned * Vec2(0.0, -groove.radius - 0.5));
        plane.angle = lean;
        scene.bodies.push_back(still(plane));
    }
    scene.bodies.push_back(disc(groove.radius, {0.0, 0.0}));
    scene.bodies.back().spin = groove.spin;
    World world = world_of(scene);
    const double braking = 2.0 * groove.mu * (pushes.left + pushes.right) * k_gravity / groove.radius;
    const double half_way = 0.5 * std::abs(groove.spin) / braking;
    run_to(world, half_way);
    return std::abs(std::abs(world.state(2).spin) / (0.5 * std::abs(groove.spin)) - 1.0);
}

Reached cones(const Share&)
{
    Reached reached;
    // In the corner of a floor and a wall, up to a friction at which the cones cross
    for (const double mu : {0.3, 0.9, 1.0, 1.05, 1.5, 2.0, 5.0, 10.0}) {
        constexpr double k_spin = 40.0;   // [rad/s]
        constexpr double k_radius = 0.25; // [m]
        Scene scene = over_floor(0.0, mu);
        scene.world.box = BoxDef{{0.0, 0.0}, {8.0, 8.0}};
        scene.bodies = {disc(k_radius, {k_radius, k_radius})};
        scene.bodies[0].spin = k_spin;
        World world = world_of(scene);
        const double floor = k_gravity / (1.0 + mu * mu);
        const double braking = 2.0 * mu * (1.0 + mu) * floor / k_radius;
        const double half_way = 0.5 * k_spin / braking;
        run_to(world, half_way);
        const double spin = std::abs(world.state(0).spin);
        reached.value = std::max(reached.value, std::abs(spin - (k_spin - braking * half_way)) / k_spin);
    }
    // In grooves of any two slopes whose planes both press
    Random random(25);
    int tried = 0;
    int off_by_more = 0;
    int ambiguous = 0;
    while (tried < 200) {
        Groove groove;
        groove.left = random.uniform(0.05, 1.5);
        groove.right = random.uniform(0.05, 1.5);
        groove.mu = std::pow(10.0, random.uniform(-1.5, 1.0));
        groove.radius = random.uniform(0.1, 1.0);
        groove.spin = (random.below(2) == 0 ? 1.0 : -1.0) * random.uniform(10.0, 60.0);
        const Pushes pushes = pushes_in(groove);
        if (std::min(pushes.left, pushes.right) < 0.01) continue; // it climbs out
        ++tried;
        ambiguous += may_wedge(groove) ? 1 : 0;
        const double off = off_in(groove, pushes);
        off_by_more += off > 1e-9 ? 1 : 0;
        if (off > std::max(reached.value, 1e-9))
            reached.remark =
                fmt::format("most at slopes {:.2f}, {:.2f}, mu {:.2f}", groove.left, groove.right, groove.mu);
        reached.value = std::max(reached.value, off);
    }
    reached.remark +=
        fmt::format("{}{} grooves off by more than asked; in {} the disc could also be wedged",
                    reached.remark.empty() ? "" : "; ", off_by_more, ambiguous);
    reached.amount =
        fmt::format("a disc that spins in a corner, mu from 0.3 to 10, and in {} grooves, mu from 0.03 to 10", tried);
    return reached;
}

Vec2 centroid_of(const std::vector<Vec2>& ring)
{
    double area = 0.0;
    Vec2 sum = Vec2::Zero();
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const double part = cross(ring[k], ring[(k + 1) % ring.size()]);
        area += part / 2.0;
        sum += (ring[k] + ring[(k + 1) % ring.size()]) * (part / 6.0);
    }
    return sum / area;
}

Reached knife_edge(const Share&)
{
    // A plate whose notch, open below, hangs on the edge of a wedge and swings
    Reached reached;
    constexpr double k_until = 5.0;
    const std::vector<Vec2> wedge = {{0.0, 0.0}, {-0.15, -2.5}, {0.15, -2.5}};
    Random random(251);
    constexpr int k_plates = 60;
    for (int k = 0; k < k_plates; ++k) {
        const double mu = std::array{0.2, 0.5, 0.8, 1.0, 2.0, 10.0}[static_cast<std::size_t>(k % 6)];
        const double half_width = random.uniform(0.8, 1.4); // of the notch, two metres below its corner [m]
        const double turned = random.uniform(-0.03, 0.03);
        const double swing = random.uniform(0.02, 0.17);
        const std::vector<Vec2> plate = {{-2.0, 0.5},        {-2.0, -2.0}, {-half_width, -2.0}, {0.0, 0.0},
                                         {half_width, -2.0}, {2.0, -2.0},  {2.0, 0.5}};
        Scene scene;
        scene.world.field = UniformField{{0.0, -k_gravity}};
        scene.world.restitution = 0.0;
        scene.world.friction = mu;
        BodyDef body;
        body.shape = PolygonDef{plate, {}};
        body.position = Rotation::of(swing) * centroid_of(plate);
        body.angle = swing;
        BodyDef edge;
        edge.shape = PolygonDef{wedge, {}};
        edge.position = Rotation::of(turned) * centroid_of(wedge);
        edge.angle = turned;
        scene.bodies = {body, still(edge)};
        World world = world_of(scene);
        const Report before = world.report();
        const double lowest = -before.bodies[0].mass * k_gravity * centroid_of(plate).norm();
        run_to(world, k_until);
        const double kept = (world.report().energy.total() - lowest) / (before.energy.total() - lowest);
        reached.value = std::max(reached.value, std::abs(1.0 - kept));
    }
    reached.amount = fmt::format("{} plates of many notches and swings, mu from 0.2 to 10, {} s", k_plates, k_until);
    return reached;
}

constexpr std::array k_trials = {
    Trial{21, "over flush tiles", "off the place on one slab [m]", 1e-9, false, "needs ghost vertices, trips without",
          flush_tiles},
    Trial{21, "a low step on the way", "lowest step that trips [m]", 1e-3, false, "", low_step},
    Trial{25, "friction cones that meet", "relative error of the spin", 1e-9, false, "", cones},
    Trial{25, "a plate that swings on a knife edge", "share of its swing lost or won", 1e-2, false, "", knife_edge},
};

} // namespace

std::span<const Trial> trials_of_corners()
{
    return k_trials;
}

} // namespace flying::stress
