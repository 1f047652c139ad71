#include "stress/random_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "math/hash.hpp"
#include "stress/random_draws.hpp"

namespace flying::stress {
namespace {

/// A shape within a circle of radius `size` about its centre of mass, or not much beyond.
ShapeDef random_shape(Random& random, SceneKind kind, double size)
{
    int which = random.below(4);
    if (kind == SceneKind::discs || kind == SceneKind::crowd) return DiscDef{size};
    if (kind == SceneKind::polygons) which = 1 + random.below(2);
    if (kind == SceneKind::concave) which = 3;
    switch (which) {
    case 0: return DiscDef{size};
    case 1: return RegularDef{3 + random.below(5), size};
    case 2: return RectangleDef{1.8 * size, log_uniform(random, 0.05, 0.85) * size};
    default: break;
    }
    if (random.below(2) == 0) {
        // An L
        const double w = 0.6 * size;
        const double t = random.uniform(0.2, 0.5) * w;
        return PolygonDef{{{-w, -w}, {w, -w}, {w, -w + t}, {-w + t, -w + t}, {-w + t, w}, {-w, w}}, {}};
    }
    // A star
    const int corners = 3 + random.below(3);
    const double inner = random.uniform(0.3, 0.7);
    PolygonDef star;
    for (int k = 0; k < 2 * corners; ++k)
        star.vertices.push_back((k % 2 == 0 ? 1.0 : inner) * 0.98 * size * direction(k_pi * k / corners));
    return star;
}

void set_matter(Random& random, Scene& scene)
{
    scene.world.restitution = random.below(2) == 0 ? 1.0 : random.uniform(0.7, 1.0);
    scene.world.friction = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.6);
}

/// Bodies in the middles of the squares of a lattice.
Scene lattice_scene(Random& random, SceneKind kind)
{
    Scene scene;
    set_matter(random, scene);
    const int side = kind == SceneKind::crowd ? 6 + random.below(3) : 2 + random.below(4);
    const double pitch = 1.0;
    const double size_share = random.uniform(0.5, 0.95);
    const bool one_size = random.below(2) == 0;
    const double speed = log_uniform(random, 0.3, 3.0);
    const double spin = random.below(3) == 0 ? 0.0 : log_uniform(random, 0.1, 20.0);
    const int statics = random.below(3) == 0 ? 0 : 6; // one in so many
    const Vec2 corner = random.below(4) == 0 ? Vec2(100.0 * direction(random.uniform(0.0, 6.3))) : Vec2(Vec2::Zero());
    for (int k = 0; k < side * side; ++k) {
        if (random.below(8) == 0) continue;
        BodyDef body;
        const double share = one_size ? 1.0 : random.uniform(0.3, 1.0);
        const double size = 0.45 * pitch * size_share * share;
        body.shape = random_shape(random, kind, size);
        body.position = corner + pitch * Vec2(k % side + 0.5, k / side + 0.5);
        const bool turned = random.below(3) != 0;
        body.angle = turned ? random.uniform(-3.0, 3.0) : 0.0;
        body.is_static = statics != 0 && random.below(statics) == 0;
        const double way = random.uniform(0.0, 6.3);
        const double fast = speed * random.uniform(0.0, 1.5);
        const double turn = spin * random.uniform(-1.0, 1.0);
        if (!body.is_static) {
            body.velocity = fast * direction(way);
            body.spin = turn;
        }
        if (random.below(4) == 0) body.density = log_uniform(random, 0.01, 100.0);
        scene.bodies.push_back(body);
    }
    if (random.below(5) != 0) scene.world.box = BoxDef{corner, corner + Vec2::Constant(side * pitch)};
    const int field = random.below(4);
    if (field == 0) scene.world.field = UniformField{speed * speed * direction(random.uniform(0.0, 6.3))};
    if (field == 1) {
        const Vec2 down = direction(random.uniform(0.0, 6.3));
        scene.world.field = UniformField{log_uniform(random, 1e-4, 0.3) * down};
    }
    scene.until = random.uniform(1.0, 4.0) * pitch / speed;
    return scene;
}

/// Bodies on rings round a centre that don't overlap at the start.
Scene central_scene(Random& random)
{
    Scene scene;
    set_matter(random, scene);
    const Vec2 centre(random.uniform(-2.0, 2.0), 1.0);
    const double mu = std::exp2(random.uniform(-2.0, 6.0));
    scene.world.field = CentralField{centre, mu, random.below(4) == 0 ? 0.0 : random.uniform(0.2, 1.0)};
    double ring = 1.5;
    const int count = 2 + random.below(6);
    for (int k = 0; k < count; ++k) {
        const double size = random.uniform(0.1, 0.5);
        ring += size;
        BodyDef body;
        body.shape = random_shape(random, SceneKind::mixed, 0.95 * size);
        body.position = centre + ring * direction(random.uniform(0.0, 6.3));
        body.angle = random.uniform(0.0, 6.0);
        body.is_static = random.below(8) == 0;
        const double way = random.uniform(0.0, 6.3);
        const bool round = random.below(3) == 0; // a circle keeps to its ring
        const double speed = (round ? 1.0 : random.uniform(0.0, 1.3)) * std::sqrt(mu / ring);
        const Vec2 out = (body.position - centre).normalized();
        const double spin = random.below(3) == 0 ? 0.0 : random.uniform(-3.0, 3.0);
        if (!body.is_static) {
            body.velocity = round ? Vec2(speed * Vec2(-out.y(), out.x())) : Vec2(speed * direction(way));
            body.spin = spin;
        }
        scene.bodies.push_back(body);
        ring += size + random.uniform(0.002, 0.1);
    }
    if (random.below(2) == 0) {
        const Vec2 half = Vec2::Constant(ring + 1.0);
        scene.world.box = BoxDef{centre - half, centre + half};
    }
    scene.until = random.uniform(0.5, 3.0) * std::sqrt(ring * ring * ring / mu);
    return scene;
}

} // namespace

const char* name_of(SceneKind kind)
{
    constexpr const char* k_names[] = {"discs", "polygons", "concave", "mixed", "crowd of discs", "central"};
    return k_names[static_cast<int>(kind)];
}

SceneKind kind_of(std::uint64_t seed)
{
    return static_cast<SceneKind>(seed % k_scene_kinds);
}

Scene random_scene(std::uint64_t seed)
{
    const SceneKind kind = kind_of(seed);
    for (std::uint64_t attempt = 0;; ++attempt) {
        Random random(Hash::mix(seed + (attempt << 48)));
        Scene scene = kind == SceneKind::central ? central_scene(random) : lattice_scene(random, kind);
        const bool any_movers = std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const BodyDef& body) { return !body.is_static; });
        if (any_movers && validate(scene).empty()) return scene;
    }
}

Trace trace_of(const Scene& scene, const std::vector<std::string>& without, std::size_t most)
{
    WorldOptions options;
    options.without = without;
    options.engine = EngineChoice::events;
    Expected<World> made = World::make(scene, options);
    Trace trace;
    if (!made) {
        trace.failed = true;
        return trace;
    }
    World world = std::move(made).value();
    constexpr std::int64_t k_most_events = 100'000;
    std::uint64_t log = world.log_hash();
    while (world.time() < scene.until && trace.moments.size() < most) {
        if (world.advance(scene.until, 1)) {
            trace.failed = true;
            break;
        }
        trace.cut_short = world.events() >= k_most_events;
        if (trace.cut_short) break;
        if (world.log_hash() == log) continue;
        log = world.log_hash();
        Hash bodies;
        double time = 0.0; // the world's clock runs on to the end after the last event
        for (const BodyState& body : world.snapshot().bodies) {
            for (const double number : {body.position.x(), body.position.y(), body.velocity.x(), body.velocity.y(), body.angle,
                                        body.spin, body.time})
                bodies.add(number);
            time = std::max(time, body.time);
        }
        trace.moments.push_back({time, log, bodies.value()});
    }
    const Report report = world.report();
    // A run that was cut short stands at an event that others may not have
    trace.end = world.time() == scene.until || trace.failed ? report.hash : 0;
    trace.skips = report.plan.skips;
    return trace;
}

std::string difference(const Trace& a, const Trace& b)
{
    char text[120];
    for (std::size_t k = 0; k < std::min(a.moments.size(), b.moments.size()); ++k) {
        if (a.moments[k] == b.moments[k]) continue;
        std::snprintf(text, sizeof text, "impact %zu differs, at %.17g and %.17g", k + 1, a.moments[k].time, b.moments[k].time);
        return text;
    }
    if (a.cut_short || b.cut_short) return "";
    if (a.moments.size() != b.moments.size()) {
        std::snprintf(text, sizeof text, "%zu impacts and %zu", a.moments.size(), b.moments.size());
        return text;
    }
    if (a.failed != b.failed) return "one run crowds, the other doesn't";
    return a.end == b.end ? "" : "the ends differ";
}

} // namespace flying::stress
