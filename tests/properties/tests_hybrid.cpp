#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "math/random.hpp"
#include "scene/generate.hpp"
#include "support/effort.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"
#include "world/world.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

double radius_of_smallest(const World& world)
{
    double smallest = 1e300;
    for (int k = 0; k < world.body_count(); ++k) {
        if (!world.is_static(k)) smallest = std::min(smallest, bounding_radius(world.shape(k)));
    }
    return smallest;
}

/// Bodies of one kind in a box, with any restitution and friction, half of them in gravity.
Scene random_hybrid_scene(std::uint64_t seed)
{
    Random random(seed);
    GenerateOptions options;
    options.seed = seed;
    options.count = 3 + random.below(20);
    options.restitution = random.uniform(0.0, 0.95);
    options.friction = random.below(3) == 0 ? 0.0 : random.uniform(0.0, 0.8);
    options.packing = random.uniform(0.05, 0.3);
    if (random.below(4) != 0) options.gravity = Vec2(0.0, -random.uniform(0.5, 10.0));
    options.until = 4.0;
    const char* kinds[] = {"balls", "gas", "polygons", "gas"};
    const int kind = random.below(4);
    if (kind == 3) {
        options.shape = "dumbbell";
        options.packing = random.uniform(0.05, 0.12);
    }
    Expected<Scene> scene = generate(kinds[kind], options);
    if (!scene) {
        options.packing = 0.05; // not every packing can be placed
        scene = generate(kinds[kind], options);
    }
    INFO("kind " << std::string(kinds[kind]) << " seed " << seed);
    REQUIRE(scene.has_value());
    return std::move(scene).value();
}

/// The energy that the run can turn over: what it had, and what falling through the box sets free.
double energy_scale(const Scene& scene, const Report& start)
{
    double mass = 0.0;
    for (const BodyReport& body : start.bodies) mass += body.mass;
    const Vec2 size = scene.world.box->max - scene.world.box->min;
    return start.energy.kinetic + mass * uniform_acceleration(scene.world.field).norm() * size.y();
}

} // namespace

namespace {

/// Follows one scene for its four seconds.
void follow(std::uint64_t seed)
{
    const Scene scene = random_hybrid_scene(seed);
    World world = world_of(scene);
    Report before = world.report();
    const double scale = energy_scale(scene, before);
    const double size = radius_of_smallest(world);
    INFO("seed " << seed);
    for (int k = 1; k <= 40; ++k) {
        const auto failure = world.advance(k / 10.0);
        INFO((failure ? failure->message : std::string()));
        REQUIRE_FALSE(failure.has_value());
        const Report now = world.report();
        INFO("t " << now.time);
        CHECK(now.energy.total() <= before.energy.total() + 1e-12 * scale);
        const double accounted = now.ledger.impacts + now.ledger.steps + now.ledger.handovers;
        CHECK(std::abs(now.energy.total() - now.initial_total - accounted) <= 1e-11 * scale);
        before = now;
    }

    // A step may leave a sixteenth of a size, where many strike many at once, and the next ones take it off
    CHECK(before.max_overlap <= 0.125 * size);
    double overlap = deepest_overlap(world);
    for (int step = 1; step <= 6 && overlap > 0.01; ++step) {
        REQUIRE_FALSE(world.advance(4.0 + step / 60.0).has_value());
        overlap = deepest_overlap(world);
    }
    CHECK(overlap <= 0.01);
}

} // namespace

TEST_CASE("over random scenes that come to rest, energy never rises, all of it is accounted for, and overlap goes")
{
    for (int k = 0; k < tried(24); ++k) follow(1 + k);
}

TEST_CASE("a gas at e = 0.1, and one of polygons at e = 0, collapse again and again, and go on to their end")
{
    // Discs that meet hardly part, so that impacts come within no time, also where nothing presses them together
    GenerateOptions options;
    options.count = 150;
    options.seed = 5;
    options.packing = 0.3;
    options.rms_speed = 1.0;
    options.friction = 0.0;
    options.restitution = 0.1;
    const Expected<Scene> discs = generate("gas", options);
    options.count = 30;
    options.packing = 0.2;
    options.friction = 0.3;
    options.restitution = 0.0;
    options.shape = "polygon";
    const Expected<Scene> polygons = generate("gas", options);
    REQUIRE(discs.has_value());
    REQUIRE(polygons.has_value());
    for (const Scene& scene : {discs.value(), polygons.value()}) {
        World world = world_of(scene);
        const double size = radius_of_smallest(world);
        Report before = world.report();
        const double start = before.energy.total();
        for (int k = 1; k <= 50; ++k) {
            const auto failure = world.advance(k);
            INFO((failure ? failure->message : std::string()));
            REQUIRE_FALSE(failure.has_value());
            const Report now = world.report();
            CHECK(now.energy.total() <= before.energy.total() + 1e-12 * start);
            before = now;
        }
        const double accounted = before.ledger.impacts + before.ledger.steps + before.ledger.handovers;
        CHECK(std::abs(before.energy.total() - start - accounted) <= 1e-11 * start);
        CHECK(before.handovers.size() >= 10);
        CHECK(before.max_overlap <= 0.01 * size); // heaps are swept
    }
}

TEST_CASE("with hand-overs, too, what happens doesn't depend on when somebody asks")
{
    int handed_over = 0;
    const int count = tried(9);
    const double intervals[] = {1.0 / 60.0, 0.1, 0.0137};
    for (int k = 0; k < count; ++k) {
        const int seed = 300 + k;
        const double interval = intervals[k % 3];
        const Scene scene = random_hybrid_scene(seed);
        World once = world_of(scene);
        REQUIRE_FALSE(once.advance(scene.until).has_value());
        const Report expected = once.report();
        handed_over += expected.handovers.empty() ? 0 : 1;
        World often = world_of(scene);
        for (int i = 1; i * interval < scene.until; ++i) {
            REQUIRE_FALSE(often.advance(i * interval).has_value());
            for (int body = 0; body < often.body_count(); ++body) (void)often.state(body);
        }
        REQUIRE_FALSE(often.advance(scene.until).has_value());
        const Report report = often.report();
        INFO("seed " << seed << ", asked every " << interval << " s");
        CHECK(report.hash == expected.hash);
        CHECK(report.handovers.size() == expected.handovers.size());
        CHECK(report.collisions == expected.collisions);
    }
    CHECK(2 * handed_over >= count);
}

TEST_CASE("with hand-overs, too, a run that is stopped, saved and resumed has the bits of one that isn't")
{
    for (const EngineChoice engine : {EngineChoice::automatic, EngineChoice::rest}) {
        WorldOptions options;
        options.engine = engine;
        const double parts[] = {0.3, 0.6337, 0.9};
        for (int k = 0; k < tried(6); ++k) {
            const int seed = 400 + k;
            const double part = parts[k % 3];
            const Scene scene = random_hybrid_scene(seed);
            Expected<World> whole = World::make(scene, options);
            REQUIRE(whole.has_value());
            (void)whole.value().advance(scene.until);
            Expected<World> first = World::make(scene, options);
            REQUIRE(first.has_value());
            (void)first.value().advance(part * scene.until);
            Expected<World> second = World::resume(scene, first.value().snapshot(), options);
            REQUIRE(second.has_value());
            for (int body = 0; body < first.value().body_count(); ++body) {
                CHECK(second.value().state(body).position == first.value().state(body).position);
            }
            (void)second.value().advance(scene.until);
            INFO("seed " << seed << ", stopped after " << part);
            CHECK(second.value().log_hash() == whole.value().log_hash());
            CHECK(second.value().report().hash == whole.value().report().hash);
            CHECK(second.value().collisions() == whole.value().collisions());
            CHECK(second.value().handovers().size() == whole.value().handovers().size());
        }
    }
}

TEST_CASE("a run by steps of so many events gets where one goes that isn't stopped")
{
    for (int i = 0; i < tried(8); ++i) {
        const Scene scene = random_hybrid_scene(500 + i);
        World once = world_of(scene);
        REQUIRE_FALSE(once.advance(scene.until).has_value());
        World parts = world_of(scene);
        for (int k = 0; k < 1000000 && parts.time() < scene.until; ++k) {
            REQUIRE_FALSE(parts.advance(scene.until, 100).has_value());
        }
        CHECK(parts.time() == scene.until);
        CHECK(parts.report().hash == once.report().hash);
    }
}
