#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "collide/separation.hpp"
#include "math/random.hpp"
#include "scene/generate.hpp"
#include "scene/read.hpp"
#include "support/effort.hpp"
#include "support/scaled_scene.hpp"
#include "support/worlds.hpp"
#include "world/world.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

Scene scene_file(const std::string& name)
{
    const Expected<Scene> scene = read_scene_file(std::string(FLYING_SOURCE_DIR) + "/chapters/scenes/" + name + ".toml");
    REQUIRE(scene.has_value());
    return scene.value();
}

/// Run to `until`, asking for a report every `interval`; the report at the end.
Report run(World& world, double until, double interval)
{
    const int steps = static_cast<int>(std::ceil(until / interval));
    for (int k = 1; k <= steps; ++k) {
        const auto failure = world.advance(std::min(until, k * interval));
        INFO((failure ? failure->message : std::string()));
        REQUIRE_FALSE(failure.has_value());
        for (int body = 0; body < world.body_count(); ++body) (void)world.state(body);
    }
    return world.report();
}

double relative_change(const Report& report)
{
    return std::abs(report.energy.total() - report.initial_total) / std::abs(report.initial_total);
}

/// Every vertex and every disc inside the box, to rounding.
void check_inside(const World& world)
{
    const BoxDef box = *world.scene().world.box;
    const double slack = 1e-10;
    const HalfPlane walls[] = {{{1.0, 0.0}, box.min.x()},
                               {{-1.0, 0.0}, -box.max.x()},
                               {{0.0, 1.0}, box.min.y()},
                               {{0.0, -1.0}, -box.max.y()}};
    for (int body = 0; body < world.body_count(); ++body) {
        if (world.is_static(body)) continue;
        for (const HalfPlane& wall : walls) {
            CHECK(separation(world.shape(body), pose_of(world.state(body)), wall, Pose{}) >= -slack);
        }
    }
}

Scene random_scene(std::uint64_t seed)
{
    Random random(seed);
    GenerateOptions options;
    options.seed = seed;
    options.count = 5 + random.below(40);
    options.restitution = random.below(2) == 0 ? 1.0 : random.uniform(0.8, 1.0);
    options.friction = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.5);
    options.packing = random.uniform(0.05, 0.3);
    if (random.below(3) == 0) options.gravity = Vec2(0.0, -1.0);
    options.until = 3.0;
    const char* kinds[] = {"balls", "gas", "polygons", "gas"};
    const int kind = random.below(4);
    if (kind == 3) {
        options.shape = "dumbbell";
        options.packing = random.uniform(0.05, 0.12);
    }
    Expected<Scene> scene = generate(kinds[kind], options);
    std::string why;
    if (!scene) why = scene.faults()[0].place + " " + scene.faults()[0].found;
    INFO("kind " << std::string(kinds[kind]) << " seed " << seed << ": " << why);
    REQUIRE(scene.has_value());
    return std::move(scene).value();
}

} // namespace

TEST_CASE("the original's scene runs for a minute with its energy, without overlap, and the same however often it is asked")
{
    for (const std::string name : {"original-polygons", "original-polygons-gravity", "balls-and-polygons"}) {
        INFO(name);
        const Scene scene = scene_file(name);
        std::vector<std::uint64_t> hashes;
        for (const double interval : {1.0 / 60.0, 1.0, scene.until}) {
            World world = events_of(scene);
            const Report report = run(world, scene.until, interval);
            CHECK(relative_change(report) <= 1e-12);
            CHECK(report.max_overlap <= 1e-10);
            check_inside(world);
            hashes.push_back(report.hash);
        }
        CHECK(hashes[0] == hashes[1]);
        CHECK(hashes[1] == hashes[2]);
    }
}

TEST_CASE("gases of discs, polygons and concave dumbbells keep their energy and never overlap")
{
    for (const std::string name : {"gas-discs-1000", "gas-polygons-200", "gas-dumbbells-100", "flying-balls"}) {
        INFO(name);
        const Scene scene = scene_file(name);
        World world = events_of(scene);
        const Report report = run(world, scene.until, scene.until);
        CHECK(relative_change(report) <= 1e-12);
        CHECK(report.max_overlap <= 1e-10);
        check_inside(world);
        CHECK(report.collisions > 1000);
    }
}

TEST_CASE("no pair is missed: sampled densely, no two bodies of a gas ever overlap")
{
    // 1/240 s at a few metres a second: an overlap that comes and goes between samples is shallower than a centimetre, and
    // bodies that passed through each other would overlap for tenths of a second
    for (const std::string name : {"gas-discs-1000", "gas-polygons-200", "gas-dumbbells-100", "original-polygons"}) {
        INFO(name);
        World world = events_of(scene_file(name));
        double deepest = 0.0;
        for (int k = 1; k <= 240; ++k) {
            REQUIRE_FALSE(world.advance(k / 240.0).has_value());
            deepest = std::max(deepest, world.report().max_overlap);
        }
        CHECK(deepest <= 1e-12);
    }
}

TEST_CASE("every skip leaves every bit as it is, over random scenes")
{
    for (int n = 0; n < tried(60); ++n) {
        const int seed = 1 + n;
        const Scene scene = random_scene(seed);
        World plain = events_of(scene);
        const auto plain_failure = plain.advance(scene.until);
        const Report expected = plain.report();
        for (const std::string& skip : skip_names()) {
            World without = events_of(scene, {skip});
            const auto failure = without.advance(scene.until);
            const Report report = without.report();
            INFO("seed " << seed << " without " << skip);
            CHECK(failure.has_value() == plain_failure.has_value());
            CHECK(without.log_hash() == plain.log_hash());
            CHECK(report.hash == expected.hash);
            CHECK(report.collisions == expected.collisions);
        }
    }
}

TEST_CASE("rows that are put in order again and again, and memory that is asked ahead, change no bit")
{
    // Long enough for every body to leave dozens of cells, against a run that knows no cells; and more bodies than the fast
    // memory holds, against the same
    struct Case
    {
        std::string shape;
        int count;
        double until;
    };
    for (const Case& one : {Case{"disc", 40, 60.0}, Case{"polygon", 40, 40.0}, Case{"disc", 4500, 0.02}}) {
        GenerateOptions options;
        options.seed = 61;
        options.count = one.count;
        options.packing = 0.1;
        options.rms_speed = 5.0;
        options.shape = one.shape;
        const Expected<Scene> scene = generate("gas", options);
        REQUIRE(scene.has_value());
        World plain = events_of(scene.value());
        World all_pairs = events_of(scene.value(), {"grid"});
        REQUIRE_FALSE(plain.advance(one.until).has_value());
        REQUIRE_FALSE(all_pairs.advance(one.until).has_value());
        INFO(one.shape << " " << one.count);
        CHECK(plain.log_hash() == all_pairs.log_hash());
        CHECK(plain.report().hash == all_pairs.report().hash);
        CHECK(plain.collisions() == all_pairs.collisions());
        for (const StageCost& stage : plain.report().stages) {
            if (stage.name == "cell" && one.count < 100) CHECK(stage.count > 3 * 16 * one.count);
        }
    }
}

TEST_CASE("energy never rises, and momentum of a closed system stays")
{
    for (int n = 0; n < tried(30); ++n) {
        const int seed = 100 + n;
        Scene scene = random_scene(seed);
        scene.world.box.reset();
        scene.world.field = NoField{};
        World world = events_of(scene);
        const Report before = world.report();
        double scale = 0.0;
        for (const BodyReport& body : before.bodies) scale += body.mass * body.state.velocity.norm();
        (void)world.advance(scene.until);
        const Report after = world.report();
        INFO("seed " << seed << ", " << after.collisions << " collisions");
        CHECK(after.energy.total() <= before.energy.total() * (1.0 + 1e-13));
        CHECK((after.momentum - before.momentum).norm() <= 1e-13 * scale);
        CHECK(std::abs(after.angular_momentum - before.angular_momentum) <= 1e-12 * scale * 20.0);
    }
}

TEST_CASE("a run that is stopped, saved and resumed has the bits of one that isn't")
{
    for (int n = 0; n < tried(15); ++n) {
        const int seed = 200 + n;
        const Scene scene = random_scene(seed);
        World whole = events_of(scene);
        (void)whole.advance(scene.until);
        World first = events_of(scene);
        if (first.advance(0.4 * scene.until)) continue;
        Expected<World> second = World::resume(scene, first.snapshot());
        REQUIRE(second.has_value());
        (void)second.value().advance(scene.until);
        INFO("seed " << seed);
        CHECK(second.value().log_hash() == whole.log_hash());
        CHECK(second.value().report().hash == whole.report().hash);
        CHECK(second.value().collisions() == whole.collisions());
    }
}

TEST_CASE("lengths, times and masses by powers of two scale a run bit for bit")
{
    for (int n = 0; n < tried(10); ++n) {
        const int seed = 300 + n;
        Scene scene = random_scene(seed);
        for (BodyDef& body : scene.bodies) body.density = 1.0;
        World plain = events_of(scene);
        (void)plain.advance(scene.until);
        for (const int power : {-40, 3, 60}) {
            const double length = std::ldexp(1.0, power);
            const double time = std::ldexp(1.0, -power / 3);
            const double density = std::ldexp(1.0, power / 2);
            const Scene scaled = in_units(scene, {length, time, density});
            World world = events_of(scaled);
            (void)world.advance(scaled.until);
            INFO("seed " << seed << ", lengths by 2^" << power);
            CHECK(world.collisions() == plain.collisions());
            for (int k = 0; k < world.body_count(); ++k) {
                CHECK(world.state(k).position == Vec2(length * plain.state(k).position));
                CHECK(world.state(k).velocity == Vec2(length / time * plain.state(k).velocity));
                CHECK(world.state(k).angle == plain.state(k).angle);
                CHECK(world.state(k).spin == plain.state(k).spin / time);
            }
        }
    }
}

TEST_CASE("mirrors and quarter turns of a gas of discs give the same bits, of polygons the same to rounding")
{
    for (const std::string shape : {"disc", "polygon"}) {
        GenerateOptions options;
        options.seed = 5;
        options.count = 40;
        options.packing = 0.2;
        options.shape = shape;
        options.friction = 0.0;
        options.until = shape == "disc" ? 5.0 : 0.5;
        Expected<Scene> made = generate("gas", options);
        REQUIRE(made.has_value());
        Scene scene = made.value();
        // Centre the box, so that its walls are mirrored exactly
        const Vec2 half = 0.5 * (scene.world.box->max - scene.world.box->min);
        const Vec2 middle = 0.5 * (scene.world.box->max + scene.world.box->min);
        const double side = std::max(half.x(), half.y()) + 1.0;
        scene.world.box = BoxDef{{-side, -side}, {side, side}};
        for (BodyDef& body : scene.bodies) body.position -= middle;
        World plain = events_of(scene);
        REQUIRE_FALSE(plain.advance(scene.until).has_value());
        REQUIRE(plain.collisions() > 10);

        const double bound = shape == "disc" ? 0.0 : 1e-9;
        const auto turn = [](const Vec2& v) { return Vec2(-v.y(), v.x()); };
        Scene turned = scene;
        for (BodyDef& body : turned.bodies) {
            body.position = turn(body.position);
            body.velocity = turn(body.velocity);
            body.angle += shape == "disc" ? 0.0 : 1.57079632679489661923;
        }
        World quarter = events_of(turned);
        (void)quarter.advance(scene.until);
        for (int k = 0; k < plain.body_count(); ++k) {
            CHECK((quarter.state(k).position - turn(plain.state(k).position)).norm() <= bound);
            CHECK((quarter.state(k).velocity - turn(plain.state(k).velocity)).norm() <= bound);
        }
        if (shape != "disc") continue;

        const auto mirror = [](const Vec2& v) { return Vec2(-v.x(), v.y()); };
        Scene mirrored = scene;
        for (BodyDef& body : mirrored.bodies) {
            body.position = mirror(body.position);
            body.velocity = mirror(body.velocity);
            body.spin = -body.spin;
        }
        World mirror_world = events_of(mirrored);
        (void)mirror_world.advance(scene.until);
        for (int k = 0; k < plain.body_count(); ++k) {
            CHECK(mirror_world.state(k).position == mirror(plain.state(k).position));
            CHECK(mirror_world.state(k).velocity == mirror(plain.state(k).velocity));
        }
    }
}
