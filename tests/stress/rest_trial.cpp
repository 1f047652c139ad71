#include "rest_trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "collide/separation.hpp"
#include "geometry/make_polygon.hpp"
#include "mass/polygon.hpp"
#include "world/world.hpp"
#include "math/random.hpp"
#include "support/random_polygons.hpp"

namespace flying::stress {
namespace {

constexpr int k_walls = 4;

/// One number out of a few.
double pick(Random& random, std::initializer_list<double> from)
{
    return from.begin()[random.below(static_cast<int>(from.size()))];
}

Shape scaled(const Polygon& polygon, double factor)
{
    std::vector<std::vector<Vec2>> rings;
    for (std::size_t k = 0; k + 1 < polygon.ring_starts().size(); ++k) {
        rings.push_back(flying::testing::placed_ring(polygon, {}, static_cast<int>(k)));
        for (Vec2& vertex : rings.back()) vertex *= factor;
    }
    const std::span<const std::vector<Vec2>> holes = std::span(rings).subspan(1);
    return make_polygon(rings[0], holes).value().polygon;
}

Shape rectangle(double width, double height)
{
    const double x = 0.5 * width;
    const double y = 0.5 * height;
    return Polygon({{Vec2(-x, -y), Vec2(x, -y), Vec2(x, y), Vec2(-x, y)}});
}

/// A shape whose bounding radius is about `size`.
Shape random_shape(Random& random, double size, int kinds)
{
    switch (random.below(kinds)) {
    case 0: return Disc{size};
    case 1: return rectangle(1.4 * size, 1.4 * size);
    case 2: {
        const double flat = random.uniform(0.05, 1.0);
        return rectangle(2.0 * size, 2.0 * size * flat);
    }
    case 3: {
        const Polygon polygon = flying::testing::random_convex(random);
        return scaled(polygon, size / polygon.radius());
    }
    case 4: {
        const Polygon polygon = flying::testing::random_star(random, false);
        return scaled(polygon, size / polygon.radius());
    }
    default: {
        const Polygon polygon = flying::testing::random_star(random, true);
        return scaled(polygon, size / polygon.radius());
    }
    }
}

RestBody wall(const Vec2& normal, double offset, const Material& material)
{
    RestBody body{HalfPlane{normal, offset}, {}, {}, material};
    body.is_static = true;
    return body;
}

/// Put a body where it overlaps no other; false where there is no room.
bool place(Random& random, const RestScene& scene, const std::vector<CollisionShape>& shapes,
           const CollisionShape& shape, RestBody& body)
{
    const double radius = bounding_radius(body.shape);
    for (int attempt = 0; attempt < 200; ++attempt) {
        const double x = random.uniform(scene.low.x() + radius, scene.high.x() - radius);
        const double y = random.uniform(scene.low.y() + radius, scene.high.y() - radius);
        body.state.position = Vec2(x, y);
        body.state.angle = random.below(3) == 0 ? 0.0 : random.uniform(-4.0, 4.0);
        bool is_free = true;
        for (std::size_t k = 0; k < scene.bodies.size() && is_free; ++k) {
            is_free = separation(shapes[k], pose_of(scene.bodies[k].state), shape, pose_of(body.state)) > 0.0;
        }
        if (is_free) return true;
    }
    return false;
}

/// What moves the bodies of a scene: the resting integrator by itself, or a world that chooses.
class Run
{
public:
    Run(const RestScene& scene, Integrator integrator) : scene_(scene)
    {
        if (integrator == Integrator::rest) {
            RestOptions options;
            options.step = scene.step;
            rest_.emplace(scene.bodies, options);
            return;
        }
        WorldOptions options;
        options.step = scene.step;
        Expected<World> world = World::make(as_scene(scene), options);
        if (world) world_.emplace(std::move(world).value());
    }

    [[nodiscard]] bool is_ready() const { return rest_ || world_; }
    [[nodiscard]] int body_count() const { return static_cast<int>(scene_.bodies.size()); }
    [[nodiscard]] const RestBody& body(int k) const { return scene_.bodies[k]; }
    /// The walls stand first and never move.
    [[nodiscard]] BodyState state(int k) const
    {
        if (rest_) return rest_->state(k);
        return k < k_walls ? scene_.bodies[k].state : world_->state(k - k_walls);
    }
    /// To the end of a step; false where the run failed.
    [[nodiscard]] bool step(int number)
    {
        if (rest_) rest_->step();
        return rest_ || !world_->advance((number + 1) * scene_.step);
    }
    [[nodiscard]] RestAccount account()
    {
        return rest_ ? RestAccount{} : world_->report().rest.value_or(RestAccount{});
    }

private:
    [[nodiscard]] static Scene as_scene(const RestScene& from);

    const RestScene& scene_;
    std::optional<RestEngine> rest_;
    std::optional<World> world_;
};

Scene Run::as_scene(const RestScene& from)
{
    Scene scene;
    scene.world.box = BoxDef{from.low, from.high};
    scene.world.restitution = from.bodies.front().material.restitution;
    scene.world.friction = from.bodies.front().material.friction;
    for (std::size_t k = k_walls; k < from.bodies.size(); ++k) {
        const RestBody& body = from.bodies[k];
        BodyDef def;
        if (const auto* disc = std::get_if<Disc>(&body.shape)) def.shape = DiscDef{disc->radius};
        else {
            const Polygon& polygon = std::get<Polygon>(body.shape);
            PolygonDef rings;
            for (std::size_t ring = 0; ring + 1 < polygon.ring_starts().size(); ++ring) {
                std::vector<Vec2> vertices = flying::testing::placed_ring(polygon, {}, static_cast<int>(ring));
                if (ring == 0) rings.vertices = std::move(vertices);
                else rings.holes.push_back(std::move(vertices));
            }
            def.shape = std::move(rings);
        }
        def.position = body.state.position;
        def.angle = body.state.angle;
        def.velocity = body.state.velocity;
        def.spin = body.state.spin;
        def.is_static = body.is_static;
        if (!body.is_static) {
            def.mass = 1.0 / body.inertia.inv_mass;
            scene.world.field = body.acceleration.isZero(0.0) ? Field(NoField{}) : Field(UniformField{body.acceleration});
        }
        def.restitution = body.material.restitution;
        def.friction = body.material.friction;
        scene.bodies.push_back(std::move(def));
    }
    return scene;
}

double energy_of(const Run& engine, const RestScene& scene)
{
    double sum = 0.0;
    for (int k = 0; k < engine.body_count(); ++k) {
        const RestBody& body = engine.body(k);
        if (body.is_static) continue;
        const BodyState s = engine.state(k);
        const double mass = 1.0 / body.inertia.inv_mass;
        sum += 0.5 * mass * s.velocity.squaredNorm() + 0.5 * s.spin * s.spin / body.inertia.inv_moment_of_inertia;
        sum -= mass * body.acceleration.dot(s.position - scene.low);
    }
    return sum;
}

/// Energy above that of all bodies in the corner that the field points to.
double energy_to_give(const Run& engine, const RestScene& scene)
{
    double sum = energy_of(engine, scene);
    for (int k = 0; k < engine.body_count(); ++k) {
        const RestBody& body = engine.body(k);
        if (body.is_static) continue;
        const Vec2 g = body.acceleration;
        const Vec2 size = scene.high - scene.low;
        sum += (std::max(g.x(), 0.0) * size.x() + std::max(g.y(), 0.0) * size.y()) / body.inertia.inv_mass;
    }
    return sum;
}

struct Measured
{
    std::vector<CollisionShape> shapes;
    std::vector<double> radius;
};

void measure_overlap(const Run& engine, const Measured& measured, int step, RestFindings& findings)
{
    findings.end_overlap = 0.0;
    for (int a = 0; a < engine.body_count(); ++a) {
        for (int b = a + 1; b < engine.body_count(); ++b) {
            if (engine.body(a).is_static && engine.body(b).is_static) continue;
            const BodyState state_a = engine.state(a);
            const BodyState state_b = engine.state(b);
            const double reach = measured.radius[a] + measured.radius[b];
            if ((state_a.position - state_b.position).squaredNorm() > reach * reach) continue;
            const double gap = separation(measured.shapes[a], pose_of(state_a), measured.shapes[b], pose_of(state_b));
            const double depth = -gap / std::min(measured.radius[a], measured.radius[b]);
            findings.end_overlap = std::max(findings.end_overlap, depth);
            if (!(depth > findings.overlap)) continue;
            findings.overlap = depth;
            findings.overlap_step = step;
            findings.overlap_a = a;
            findings.overlap_b = b;
        }
    }
}

} // namespace

RestScene make_rest_scene(std::uint64_t seed)
{
    Random random(seed * 7919u + 1u);
    RestScene scene;
    const double unit = pick(random, {1.0, 1.0, 1e-3, 1e4}); // [m]
    const double side = unit * random.uniform(4.0, 20.0);
    const double height = unit * random.uniform(4.0, 20.0);
    scene.low = unit * Vec2(random.uniform(-10.0, 0.0), 0.0);
    scene.high = scene.low + Vec2(side, height);
    const Material material{pick(random, {0.0, 0.5, 1.0, random.uniform()}),
                            pick(random, {0.0, 0.3, 1.0, 3.0 * random.uniform()})};
    const double pull = unit * pick(random, {0.0, 10.0, 10.0, 40.0 * random.uniform()}); // [m/s^2]
    const double turn = random.below(3) == 0 ? random.uniform(-3.0, 3.0) : 0.0;
    const Vec2 gravity = pull * Vec2(std::sin(turn), -std::cos(turn));
    const double speed = unit * pick(random, {0.0, 3.0, 30.0 * random.uniform()});
    const double spin = pick(random, {0.0, 3.0, 30.0 * random.uniform()});
    const double spread = pick(random, {0.0, 1.0, 3.0});              // decades of size
    const int kinds = 1 + random.below(6);
    const double heavy = pick(random, {0.0, 0.0, 2.0, 6.0});          // decades of density
    const int count = 1 + random.below(random.below(4) == 0 ? 40 : 14);
    scene.step = pick(random, {1.0 / 60.0, 1.0 / 60.0, 1.0 / 240.0, 1.0 / 30.0});
    scene.steps = static_cast<int>(5.0 / scene.step);

    scene.bodies = {wall({1.0, 0.0}, scene.low.x(), material), wall({-1.0, 0.0}, -scene.high.x(), material),
                    wall({0.0, 1.0}, scene.low.y(), material), wall({0.0, -1.0}, -scene.high.y(), material)};
    std::vector<CollisionShape> shapes;
    for (const RestBody& body : scene.bodies) shapes.push_back(make_collision_shape(body.shape));
    const int blocks = random.below(3) == 0 ? random.below(4) : 0;
    for (int k = 0; k < count + blocks; ++k) {
        const double size = unit * std::pow(10.0, -spread * random.uniform());
        const bool is_block = k < blocks;
        RestBody body{random_shape(random, is_block ? unit : size, is_block ? 6 : kinds), {}, {}, material};
        body.is_static = is_block;
        if (random.below(4) == 0) body.material.restitution = random.uniform();
        if (random.below(4) == 0) body.material.friction = random.uniform();
        if (!is_block) {
            const MassProperties mass = mass_of(body.shape, std::pow(10.0, heavy * random.uniform()));
            body.inertia = {1.0 / mass.mass, 1.0 / mass.moment_of_inertia};
            body.acceleration = gravity;
            const double v_x = random.uniform(-speed, speed);
            const double v_y = random.uniform(-speed, speed);
            body.state.velocity = Vec2(v_x, v_y);
            body.state.spin = random.uniform(-spin, spin);
        }
        CollisionShape shape = make_collision_shape(body.shape);
        if (!place(random, scene, shapes, shape, body)) continue;
        scene.bodies.push_back(body);
        shapes.push_back(std::move(shape));
    }
    const auto text = [](double x) { return std::to_string(x); };
    scene.label = std::to_string(scene.bodies.size() - k_walls) + " bodies, e " + text(material.restitution) + ", mu " +
                  text(material.friction) + ", g " + text(pull / unit) + ", v " + text(speed / unit) + ", w " +
                  text(spin) + ", kinds " + std::to_string(kinds) + ", sizes 1e-" + text(spread) + ", densities 1e" +
                  text(heavy) + ", step 1/" + text(1.0 / scene.step);
    return scene;
}

RestFindings run_rest_scene(const RestScene& scene, int look_every, Integrator integrator)
{
    RestFindings findings;
    Run engine(scene, integrator);
    if (!engine.is_ready()) {
        findings.finite = false;
        return findings;
    }
    Measured measured;
    for (const RestBody& body : scene.bodies) {
        measured.shapes.push_back(make_collision_shape(body.shape));
        measured.radius.push_back(bounding_radius(body.shape));
    }
    const double scale = energy_to_give(engine, scene);
    double least = energy_of(engine, scene);
    for (int k = 0; k < scene.steps; ++k) {
        if (!engine.step(k)) {
            findings.finite = false;
            return findings;
        }
        const double now = energy_of(engine, scene);
        if (!std::isfinite(now)) {
            findings.finite = false;
            return findings;
        }
        const double rise = scale > 0.0 ? (now - least) / scale : 0.0;
        if (rise > findings.rise) {
            findings.rise = rise;
            findings.rise_step = k;
        }
        least = std::min(least, now);
        if (k % look_every == 0 || k + 1 == scene.steps) measure_overlap(engine, measured, k, findings);
    }
    findings.rest = engine.account();
    for (int k = 0; k < engine.body_count(); ++k) {
        const RestBody& body = engine.body(k);
        if (body.is_static) continue;
        const Vec2 x = engine.state(k).position;
        const bool inside = x.x() > scene.low.x() && x.x() < scene.high.x() && x.y() > scene.low.y() &&
                            x.y() < scene.high.y();
        if (!inside) ++findings.lost;
    }
    return findings;
}

bool ends_well(const RestFindings& findings)
{
    return findings.finite && findings.lost == 0 && findings.rise <= k_rise_allowed &&
           findings.end_overlap <= k_overlap_allowed;
}

bool passes(const RestFindings& findings)
{
    return ends_well(findings) && findings.overlap <= k_overlap_allowed;
}

} // namespace flying::stress
