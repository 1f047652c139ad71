// Bodies that lean: heavy on light, tall, rough, poured, linked.

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numbers>

#include <fmt/format.h>

#include "collide/separation.hpp"
#include "geometry/aabb.hpp"
#include "math/random.hpp"
#include "table/trials.hpp"

namespace flying::stress {
namespace {

/// Unit boxes one on the other over a floor.
Scene stack_of(int count)
{
    Scene scene = over_floor(0.0, 0.5);
    for (int k = 0; k < count; ++k) scene.bodies.push_back(rectangle(1.0, 1.0, {0.0, 0.5 + k}));
    return scene;
}

double farthest_from_start(const World& world)
{
    double farthest = 0.0;
    for (int k = 0; k < world.body_count(); ++k) {
        const Vec2 start = world.scene().bodies[static_cast<std::size_t>(k)].position;
        farthest = std::max(farthest, (world.state(k).position - start).norm());
    }
    return farthest;
}

Reached heavy_on_light(const Share&)
{
    Reached reached;
    double worst = 0.0;
    for (const double ratio : {1e2, 1e3, 1e4, 1e6, 1e9, 1e12}) {
        Scene scene = stack_of(2);
        scene.bodies[1].density = ratio;
        World world = world_of(scene);
        run_to(world, 20.0);
        const double moved = std::max(farthest_from_start(world), world.report().max_overlap);
        if (moved > 1e-3) break;
        worst = std::max(worst, moved);
        reached.value = ratio;
    }
    reached.amount = "20 s at each of 1e2, 1e3, 1e4, 1e6, 1e9, 1e12";
    reached.remark = fmt::format("moves by {:.1e} sides at most", worst);
    return reached;
}

Reached tall_stack(const Share&)
{
    Reached reached;
    double sag = 0.0;
    for (const int count : {10, 50, 200, 1000}) {
        World world = world_of(stack_of(count));
        run_to(world, 60.0);
        sag = count - 0.5 - world.state(count - 1).position.y();
        if (std::abs(sag) > 0.01 || farthest_from_start(world) > 0.01) break;
        reached.value = count;
    }
    reached.amount = "60 s at each of 10, 50, 200, 1000";
    reached.remark = fmt::format("the last one's top sinks by {:.1e} m", sag);
    return reached;
}

/// How far a block has gone on a slope after a time; it is too flat to tip.
double slid(double tilt, double mu, double time, const WorldOptions& options = {})
{
    Scene scene = over_floor(0.0, mu, tilt);
    scene.bodies = {rectangle(4.0, 1.0, {0.0, 0.5})};
    World world = world_of(scene, options);
    run_to(world, time);
    return (world.state(0).position - scene.bodies[0].position).norm();
}

Reached stick(const Share&)
{
    Reached reached;
    reached.value = 1.0;
    for (const double off : {1e-3, 1e-6, 1e-9, 1e-10, 1e-11, 1e-12}) {
        bool is_right = true;
        for (const double tilt : {0.1, 0.5, 1.0}) {
            const double tangent = std::tan(tilt);
            const double way = 50.0 * k_gravity * std::sin(tilt) * off;
            is_right = is_right && slid(tilt, (1.0 + off) * tangent, 10.0) == 0.0;
            is_right = is_right && std::abs(slid(tilt, (1.0 - off) * tangent, 10.0) / way - 1.0) < 0.01;
        }
        if (!is_right) break;
        reached.value = off;
    }
    reached.amount = "three slopes, 10 s each";
    reached.remark = "below, rounding of sine, cosine and friction decides";
    return reached;
}

Reached tip(const Share&)
{
    Reached reached;
    reached.value = 1.0;
    for (const double off : {1e-3, 1e-6, 1e-9, 1e-10, 1e-11, 1e-12}) {
        bool is_right = true;
        for (const double more : {-off, off}) {
            Scene scene = over_floor(0.0, 5.0, std::atan((1.0 + more) * 0.7));
            scene.bodies = {rectangle(0.7, 1.0, {0.0, 0.5})};
            World world = world_of(scene);
            run_to(world, 10.0);
            is_right = is_right && (std::abs(world.state(0).angle) > off) == (more > 0.0);
        }
        if (!is_right) break;
        reached.value = off;
    }
    reached.amount = "a block on a rough slope, 10 s each";
    return reached;
}

Reached creep(const Share&)
{
    WorldOptions awake;
    awake.without = {"sleeping"};
    Reached reached;
    for (const double tilt : {0.1, 0.5, 1.0}) {
        reached.value = std::max(reached.value, slid(tilt, 1.001 * std::tan(tilt), 3600.0));
        reached.value = std::max(reached.value, slid(tilt, 1.001 * std::tan(tilt), 3600.0, awake));
    }
    reached.amount = "three slopes, an hour of 216000 steps each, asleep and kept awake";
    return reached;
}

Reached last_bounce(const Share&)
{
    Reached reached;
    int tried = 0;
    for (const double e : {0.1, 0.3, 0.5, 0.7, 0.9}) {
        for (const double height : {1e-3, 4.9, 1e3}) {
            Scene scene = over_floor(e, 0.0);
            scene.bodies = {disc(0.5, {0.0, 0.5 + height})};
            World world = world_of(scene);
            const double fall = scene.bodies[0].position.y() - 0.5; // what rounding has left of the height
            const double end = std::sqrt(2.0 * fall / k_gravity) * (1.0 + e) / (1.0 - e);
            run_to(world, 1.01 * end);
            if (world.handovers().empty()) throw std::runtime_error("no hand-over");
            reached.value = std::max(reached.value, std::abs(world.handovers()[0].time / end - 1.0));
            ++tried;
        }
    }
    reached.amount = fmt::format("{} balls of e from 0.1 to 0.9, from 1 mm, 4.9 m and 1 km", tried);
    return reached;
}

Reached collapse(const Share&)
{
    constexpr int k_side = 100;
    constexpr double k_spacing = 1.7; // packing 0.27
    Scene scene;
    scene.world.restitution = 0.1;
    scene.world.box = BoxDef{{0.0, 0.0}, {k_spacing * k_side, k_spacing * k_side}};
    Random random(19);
    for (int k = 0; k < k_side * k_side; ++k) {
        const double vx = random.uniform(-1.0, 1.0);
        const double vy = random.uniform(-1.0, 1.0);
        scene.bodies.push_back(disc(0.5, k_spacing * Vec2(k % k_side + 0.5, k / k_side + 0.5), {vx, vy}));
    }
    World world = world_of(scene);
    run_to(world, 100.0);
    const Report report = world.report();
    const double accounted = report.ledger.impacts + report.ledger.steps + report.ledger.handovers;
    Reached reached;
    reached.value = std::abs(report.energy.total() - report.initial_total - accounted) / report.initial_total;
    reached.amount = fmt::format("{} discs, 100 s: {} impacts", report.bodies.size(), report.collisions);
    reached.remark = fmt::format("{} hand-overs; {:.1e} of the energy is left", report.handovers.size(),
                                 report.energy.total() / report.initial_total);
    return reached;
}

Reached flush_tiles(const Share&)
{
    Reached reached;
    Random random(21);
    constexpr int k_boxes = 60;
    for (int k = 0; k < k_boxes; ++k) {
        const double tiles[] = {0.25, 1.0 / 3.0, 0.37, 0.5, 1.0, 2.0};
        const double tile = tiles[random.below(6)];
        const double mu = k % 2 == 0 ? 0.0 : random.uniform(0.1, 0.9);
        BodyDef box = rectangle(random.uniform(0.4, 1.4), 0.5, {random.uniform(0.0, 2.0), 0.25});
        box.velocity = {random.uniform(0.5, 15.0), 0.0};
        Vec2 end[2];
        for (const bool is_slab : {false, true}) {
            Scene scene;
            scene.world.field = UniformField{{0.0, -k_gravity}};
            scene.world.restitution = 0.3;
            scene.world.friction = mu;
            const double width = is_slab ? 40.0 : tile;
            for (int i = 0; i < static_cast<int>(40.0 / width + 1e-9); ++i)
                scene.bodies.push_back(still(rectangle(width, 0.3, {-2.0 + (i + 0.5) * width, -0.15})));
            scene.bodies.push_back(box);
            World world = world_of(scene);
            run_to(world, 1.5);
            end[is_slab ? 1 : 0] = world.state(static_cast<int>(scene.bodies.size()) - 1).position;
        }
        reached.value = std::max(reached.value, (end[0] - end[1]).norm());
    }
    reached.amount = fmt::format("{} boxes, tiles of 0.25 to 2 m, up to 15 m/s", k_boxes);
    return reached;
}

/// Discs and polygons of sizes over 1 : 20 on a lattice, to fall into a bin.
Scene heap_of(int count, double heaviest, Random& random)
{
    Scene scene = over_floor(0.0, 0.5);
    scene.world.box = BoxDef{{0.0, 0.0}, {12.0, 400.0}};
    for (int k = 0; k < count; ++k) {
        const double radius = 0.5 * std::pow(20.0, -random.uniform());
        BodyDef body = disc(radius, {0.5 + k % 11 + random.uniform(0.0, 0.4), 0.6 + 1.1 * (k / 11)});
        if (k % 2 == 1) body.shape = RegularDef{3 + random.below(5), radius};
        const double area = std::numbers::pi * radius * radius;
        body.density = std::pow(heaviest, random.uniform()) / area;
        scene.bodies.push_back(body);
    }
    return scene;
}

/// Deepest overlap of two bodies, or of one with the box, over the radius of the smaller one.
double deepest_overlap(const World& world)
{
    const BoxDef& box = *world.scene().world.box;
    std::vector<CollisionShape> shapes;
    std::vector<double> radius;
    for (int k = 0; k < world.body_count(); ++k) {
        shapes.push_back(make_collision_shape(world.shape(k)));
        radius.push_back(bounding_radius(world.shape(k)));
    }
    double deepest = 0.0;
    for (int a = 0; a < world.body_count(); ++a) {
        const Pose pose = pose_of(world.state(a));
        const flying::Aabb bounds = flying::bounding_box(world.shape(a), pose);
        const double out = std::max((box.min - bounds.min).maxCoeff(), (bounds.max - box.max).maxCoeff());
        deepest = std::max(deepest, out / radius[static_cast<std::size_t>(a)]);
        for (int b = a + 1; b < world.body_count(); ++b) {
            const auto i = static_cast<std::size_t>(a);
            const auto j = static_cast<std::size_t>(b);
            const Pose other = pose_of(world.state(b));
            if ((pose.position - other.position).norm() > radius[i] + radius[j]) continue;
            deepest = std::max(deepest, -separation(shapes[i], pose, shapes[j], other) / std::min(radius[i], radius[j]));
        }
    }
    return deepest;
}

Reached unequal_heap(const Share&)
{
    Reached reached;
    double fastest = 0.0;
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        Random random(seed);
        World world = world_of(heap_of(200, 1e4, random));
        run_to(world, 20.0);
        reached.value = std::max(reached.value, deepest_overlap(world));
        for (int k = 0; k < world.body_count(); ++k) fastest = std::max(fastest, world.state(k).velocity.norm());
    }
    reached.amount = "three heaps of 200 discs and polygons, 20 s";
    reached.remark = fmt::format("the fastest body then goes at {:.1e} m/s", fastest);
    return reached;
}

Reached smooth_floor(const Share&)
{
    // Rough towers that slide and fall over on a smooth floor, far from any wall
    Scene scene = over_floor(0.0, 0.5);
    scene.world.box.reset();
    BodyDef floor = still(rectangle(4000.0, 2.0, {0.0, -1.0}));
    floor.friction = 0.0;
    scene.bodies = {floor};
    Random random(23);
    for (int tower = 0; tower < 100; ++tower) {
        const double speed = random.uniform(-1.0, 1.0);
        for (int k = 0; k < 10; ++k)
            scene.bodies.push_back(rectangle(1.0, 1.0, {4.0 * (tower - 50) + random.uniform(-0.3, 0.3), 0.5 + k}, {speed, 0.0}));
    }
    World world = world_of(scene);
    const double before = world.report().momentum.x();
    double sum = 0.0;
    for (const BodyDef& body : scene.bodies) sum += std::abs(body.velocity.x()); // of one kilogramme each
    run_to(world, 5.0);
    const Report report = world.report();
    Reached reached;
    reached.value = std::abs(report.momentum.x() - before) / sum;
    reached.amount = "100 towers of ten boxes, 5 s";
    reached.remark = fmt::format("{} bodies lean or sleep at the end", std::count_if(report.bodies.begin(), report.bodies.end(), [&](const BodyReport& body) {
                                     return world.mover(static_cast<int>(&body - report.bodies.data())) != BodyMover::events;
                                 }));
    return reached;
}

Reached touching_start(const Share&)
{
    Reached reached;
    std::int64_t impacts = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        Scene scene;
        scene.world.box = BoxDef{{0.0, 0.0}, {8.0, 8.0}};
        if (seed % 2 == 0) scene.world.field = UniformField{{0.0, -1.0}};
        const int side = 3 + random.below(4);
        for (int k = 0; k < side * side; ++k) {
            const double vx = random.uniform(-1.0, 1.0);
            const double vy = random.uniform(-1.0, 1.0);
            const Vec2 place(0.5 + k % side, 0.5 + k / side);
            scene.bodies.push_back(seed % 4 < 2 ? disc(0.5, place, {vx, vy}) : rectangle(1.0, 1.0, place, {vx, vy}));
        }
        World world = world_of(scene);
        const auto failure = world.advance(5.0);
        if (failure) throw std::runtime_error(failure->message);
        const Report report = world.report();
        impacts += report.collisions;
        reached.value = std::max(reached.value, std::abs(report.energy.total() / report.initial_total - 1.0));
    }
    reached.amount = fmt::format("40 lattices of discs or boxes, {} impacts", impacts);
    return reached;
}

Reached cones(const Share&)
{
    // A disc spins in the corner of floor and wall. Both contacts slip: two equations for two forces
    Reached reached;
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
    reached.amount = "a disc that spins in a corner, mu from 0.3 to 10";
    return reached;
}

double seconds_of_computing() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A bar with a knob at its right end and a jaw at its left that holds such a knob; its knob lies one unit right of its jaw.
PolygonDef link_shape()
{
    std::vector<Vec2> outline;
    const auto arc = [&](const Vec2& centre, double radius, double from, double to, int count) {
        for (int k = 0; k <= count; ++k) {
            const double angle = from + (to - from) * k / count;
            outline.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
        }
    };
    constexpr double k_pi = std::numbers::pi;
    const Vec2 knob(1.0, 0.0);
    arc(knob, 0.10, -k_pi + 0.5, k_pi - 0.5, 10);    // round the knob, from below the neck to above it
    arc(Vec2::Zero(), 0.30, 0.16, k_pi - 0.55, 8);   // over the back of the jaw
    arc(Vec2::Zero(), 0.14, k_pi - 0.75, -k_pi + 0.75, 10); // inside it, back again
    arc(Vec2::Zero(), 0.30, -k_pi + 0.55, -0.16, 8); // under the back of the jaw
    return {outline, {}};
}

Reached chain(const Share&)
{
    constexpr int k_links = 30;
    Scene scene = over_floor(0.2, 0.3);
    scene.world.box = BoxDef{{-40.0, -40.0}, {40.0, 40.0}};
    // Given about the jaw's centre, moved to the centroid: where that is, the world says
    BodyDef one;
    one.shape = link_shape();
    scene.bodies = {one};
    const World probe = world_of(scene);
    const Vec2 corner = std::get<Polygon>(probe.shape(0)).vertices()[0];
    const Vec2 centroid = std::get<PolygonDef>(one.shape).vertices[0] - corner;
    scene.bodies.clear();
    for (int k = 0; k <= k_links; ++k) {
        one.position = centroid + Vec2(static_cast<double>(k), 0.0);
        one.is_static = k == k_links; // held by the last one's jaw
        scene.bodies.push_back(one);
    }
    World world = world_of(scene);
    const double started = seconds_of_computing();
    constexpr double k_until = 3.0;
    run_to(world, k_until);
    Reached reached;
    reached.value = (seconds_of_computing() - started) / k_until;
    reached.amount = fmt::format("{} links that hang from one, {} s", k_links, k_until);
    reached.remark = fmt::format("overlap {:.1e} sizes at the end", deepest_overlap(world));
    return reached;
}

Reached rings(const Share&)
{
    constexpr int k_rings = 150;
    Scene scene = over_floor(0.2, 0.0);
    scene.world.box = BoxDef{{0.0, 0.0}, {10.0, 60.0}};
    PolygonDef ring;
    ring.holes.emplace_back();
    for (int k = 0; k < 12; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 12;
        ring.vertices.push_back(0.4 * Vec2(std::cos(angle), std::sin(angle)));
        ring.holes[0].push_back(0.3 * Vec2(std::cos(angle), std::sin(angle)));
    }
    Random random(26);
    for (int k = 0; k < k_rings; ++k) {
        BodyDef body;
        body.shape = ring;
        body.position = {0.6 + 0.95 * (k % 10) + random.uniform(-0.05, 0.05), 0.6 + 0.95 * (k / 10)};
        scene.bodies.push_back(body);
    }
    World world = world_of(scene);
    const double started = seconds_of_computing();
    constexpr double k_until = 3.0;
    run_to(world, k_until);
    Reached reached;
    reached.value = (seconds_of_computing() - started) / k_until;
    reached.amount = fmt::format("{} rings of twelve sides poured into a bin, {} s", k_rings, k_until);
    reached.remark = fmt::format("overlap {:.1e} sizes at the end", deepest_overlap(world));
    return reached;
}

constexpr std::array k_trials = {
    Trial{1, "a heavy box on a light one", "largest ratio of masses that stands", 1e4, true, "1e2 at 60 steps a second", heavy_on_light},
    Trial{2, "a stack of boxes", "boxes that stand for a minute", 200.0, true, "50, sagging by 0.85", tall_stack},
    Trial{10, "sticking on a slope", "distance from mu = tan t still told", 1e-9, false, "1e-2", stick},
    Trial{10, "tipping on a slope", "distance from tan t = b/h still told", 1e-9, false, "5e-3", tip},
    Trial{10, "creep on a slope", "way in an hour [m]", 0.0, false, "", creep},
    Trial{11, "the end of the bounces", "relative error of its time", 1e-12, false, "5e-2", last_bounce},
    Trial{19, "a gas that collapses, e = 0.1", "share of the energy unaccounted for", 1e-11, false, "the number of events diverges", collapse},
    Trial{21, "a box over flush tiles", "off the place on one slab [m]", 1e-9, false, "needs ghost vertices, trips without", flush_tiles},
    Trial{22, "a heap of masses 1 : 1e4, sizes 1 : 20", "overlap over the smaller size", 1e-2, false, "", unequal_heap},
    Trial{23, "towers on a smooth floor", "share of the momentum gained", 1e-12, false, "", smooth_floor},
    Trial{24, "touching at the start, e = 1", "relative change of energy", 1e-9, false, "", touching_start},
    Trial{25, "friction cones that meet", "relative error of the spin", 1e-9, false, "", cones},
    Trial{26, "a chain of interlocked links", "seconds of computing a second", 1.0, false, "", chain},
    Trial{26, "rings poured", "seconds of computing a second", 1.0, false, "", rings},
};

} // namespace

std::span<const Trial> trials_of_rest()
{
    return k_trials;
}

} // namespace flying::stress
