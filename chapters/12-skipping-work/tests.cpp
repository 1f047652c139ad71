#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "../support/lying_bodies.hpp"
#include "math/roots.hpp"
#include "plain_engine.hpp"
#include "runs.hpp"
#include "scene/generate.hpp"
#include "support/receipts.hpp"

using namespace flying;

namespace {

/// A few bodies of some kind, with and without gravity and friction.
Scene random_scene(std::uint64_t seed)
{
    Random random(seed);
    GenerateOptions options;
    options.seed = seed;
    options.count = 5 + random.below(30);
    options.restitution = random.below(2) == 0 ? 1.0 : random.uniform(0.8, 1.0);
    options.friction = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.5);
    options.packing = random.uniform(0.05, 0.2);
    if (random.below(3) == 0) options.gravity = Vec2(0.0, -1.0);
    options.until = 1.5;
    const char* kinds[] = {"balls", "gas", "polygons"};
    Expected<Scene> scene = generate(kinds[random.below(3)], options);
    REQUIRE(scene.has_value());
    return std::move(scene).value();
}

/// So many static discs in a row, and one disc that flies past them.
Scene row_of_statics(int count)
{
    Scene scene;
    for (int k = 0; k <= count; ++k) {
        BodyDef body;
        body.shape = DiscDef{0.4};
        body.position = Vec2(k, k == count ? 3.0 : 0.0);
        body.is_static = k < count;
        if (k == count) body.velocity = Vec2(1.0, 0.0);
        scene.bodies.push_back(body);
    }
    return scene;
}

/// So many discs, boxes or polygons of different sizes that fall on a heap.
Scene pile(const char* shape, int count, std::uint64_t seed)
{
    GenerateOptions options;
    options.seed = seed;
    options.count = count;
    options.shape = shape;
    options.radius = Bounds{0.1, 0.3};
    options.restitution = 0.1 * static_cast<double>(seed % 6);
    options.friction = 0.15 * static_cast<double>(seed);
    return generate("pile", options).value();
}

const Skip& skip_named(const Plan& plan, const std::string& name)
{
    for (const Skip& skip : plan.skips) {
        if (skip.name == name) return skip;
    }
    FAIL("no skip " << name);
    return plan.skips.front();
}

} // namespace

// [skipping-work.tests.every]
TEST_CASE("with any skip off that isn't altering, the log after every impact has the same "
          "hash, on every random scene")
{
    long impacts = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const Scene scene = random_scene(1200 + seed);
        const Run plain = run(scene, scene.until);
        impacts += static_cast<long>(plain.hashes.size());
        for (const Skip& skip : make_plan(scene).skips) {
            if (skip.kind == SkipClass::altering) continue;
            INFO("seed " << seed << " without " << skip.name);
            const Run without = run(scene, scene.until, {skip.name});
            CHECK(without.hashes == plain.hashes);
            CHECK(without.report.hash == plain.report.hash);
        }
    }
    CHECK(impacts > 1000);
}
// [skipping-work.tests.every]

// [skipping-work.tests.pure]
TEST_CASE("a plan is a function of the scene: it depends neither on motion nor on names, "
          "and each skip can be turned off")
{
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        Scene scene = random_scene(1300 + seed);
        const Plan plan = make_plan(scene);
        for (BodyDef& body : scene.bodies) body.velocity = -body.velocity;
        std::reverse(scene.bodies.begin(), scene.bodies.end());
        const Plan again = make_plan(scene);
        REQUIRE(again.skips.size() == plan.skips.size());
        for (std::size_t k = 0; k < plan.skips.size(); ++k) {
            CHECK(again.skips[k].active == plan.skips[k].active);
            CHECK(again.skips[k].reason == plan.skips[k].reason);
            CHECK_FALSE(plan.skips[k].reason.empty());
            CHECK((plan.skips[k].kind == SkipClass::altering) == (plan.skips[k].name == "warm-start"));
            const Plan without = make_plan(scene, {plan.skips[k].name});
            CHECK_FALSE(without.skips[k].active);
        }
    }
}
// [skipping-work.tests.pure]


TEST_CASE("the plan names what the course's scenes don't need")
{
    const auto plan_of = [](const char* name) {
        return make_plan(scene_of_course(FLYING_SCENES, name));
    };
    CHECK(plan_of("gas-discs-1000").pair_finder == PairFinder::grid);
    CHECK(plan_of("original-polygons").pair_finder == PairFinder::all_pairs);
    CHECK(plan_of("orbits").pair_finder == PairFinder::all_pairs);
    CHECK_FALSE(skip_named(plan_of("gas-discs-1000"), "far-features").active);
    CHECK(skip_named(plan_of("gas-polygons-200"), "far-features").active);
    CHECK_FALSE(skip_named(plan_of("pi-billiard"), "static-pairs").active);
}



TEST_CASE("f static bodies save f (f - 1) / 2 pairs")
{
    for (int f = 2; f <= 40; ++f) {
        const Run made = run(row_of_statics(f), 0.1);
        const auto saved =
            static_cast<double>(skip_named(made.report.plan, "static-pairs").saved);
        CHECK_EQUATION("plan.static", saved, 0.5 * f * (f - 1), 0.0, {"f", f});
        CHECK_TWIN("plan.static", saved, 0.5 * f * (f + 1), 0.0);
    }
}



TEST_CASE("circles overlap for the chord of their path over the speed: on average, for a "
          "quarter of pi of the longest chord")
{
    Random random(1211);
    for (int i = 0; i < 1000; ++i) {
        const double r = random.uniform(0.5, 2.0);
        const double b = r * random.uniform(0.0, 0.99);
        const double v = random.uniform(0.5, 5.0);
        const Passage passage = passage_through_circle(Vec2(-10.0, b), Vec2(v, 0.0), r);
        const double tau = passage.leave - passage.enter;
        CHECK_EQUATION("plan.passage", tau, 2.0 * std::sqrt(r * r - b * b) / v, 1e-13,
                       {"r", r}, {"b", b}, {"v", v});
        CHECK_TWIN("plan.passage", tau, 2.0 * std::sqrt(r * r + b * b) / v, 1e-13);
    }
    for (int i = 1; i <= 20; ++i) {
        const double r = 0.1 * i;
        const double v = 3.0;
        double sum = 0.0;
        constexpr int k_paths = 10'000;
        for (int k = 0; k < k_paths; ++k) {
            const double b = r * (k + 0.5) / k_paths;
            const Passage passage = passage_through_circle(Vec2(-10.0, b), Vec2(v, 0.0), r);
            sum += passage.leave - passage.enter;
        }
        // Midpoints of a curve that is upright at its end: an error like the power -3/2 of
        // their number
        const double mean = sum / k_paths;
        CHECK_EQUATION("plan.mean_passage", mean, std::numbers::pi * r / (2.0 * v), 1e-6,
                       {"r", r}, {"v", v});
        CHECK_TWIN("plan.mean_passage", mean, 2.0 * r / v, 1e-6);
    }
}


// [skipping-work.tests.sleep]
TEST_CASE("a stack that sleeps has the bits of one that is kept awake")
{
    RestOptions awake;
    awake.sleeps = false;
    RestEngine one(test::stack(5), RestOptions{});
    RestEngine two(test::stack(5), awake);
    for (int step = 0; step < 600; ++step) {
        one.step();
        two.step();
        for (int k = 0; k <= 5; ++k) {
            CHECK(one.state(k).position == two.state(k).position);
            CHECK(one.state(k).velocity == two.state(k).velocity);
            CHECK(one.state(k).angle == two.state(k).angle);
        }
    }
    // [skipping-work.tests.sleep.counts]
    CHECK(one.counts().asleep > 0);
    CHECK(two.counts().asleep == 0);
    RECORD_VALUE("skipping-work.asleep", one.counts().asleep);
    RECORD_VALUE("skipping-work.groups", one.counts().islands);
    RECORD_VALUE("skipping-work.groups_awake", two.counts().islands);
    // [skipping-work.tests.sleep.counts]
}
// [skipping-work.tests.sleep]

// [skipping-work.tests.poured]
TEST_CASE("piles that are poured have the same bits whether steps leave out what sleeps or not")
{
    std::int64_t left_out = 0;
    for (const char* shape : {"disc", "box", "polygon"}) {
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            const Scene scene = pile(shape, 30, seed);
            World one = World::make(scene).value();
            World other = World::make(scene, {.without = {"sleeping"}}).value();
            for (int k = 1; k <= 120; ++k) {
                REQUIRE_FALSE(one.advance(k / 30.0));
                REQUIRE_FALSE(other.advance(k / 30.0));
                REQUIRE(one.report().hash == other.report().hash);
            }
            left_out += skip_named(one.report().plan, "sleeping").saved;
        }
    }
    CHECK(left_out > 5'000);
}
// [skipping-work.tests.poured]

// [skipping-work.tests.spoilt]
TEST_CASE("a bound that is a hundredth too small is found by the hash of the first impact "
          "that it spoils: energy sees nothing")
{
    int found = 0;
    for (std::uint64_t seed = 121; seed < 131; ++seed) {
        PlainEngine none(hexagons(seed), Bound::none);
        PlainEngine right(hexagons(seed), Bound::right);
        PlainEngine spoilt(hexagons(seed), Bound::spoilt);
        const double before = none.energy();
        bool differs = false;
        // [skipping-work.tests.spoilt.steps]
        for (int k = 0; k < 200; ++k) {
            REQUIRE(none.step());
            REQUIRE(right.step());
            REQUIRE(spoilt.step());
            CHECK(right.hash() == none.hash());
            differs = differs || spoilt.hash() != none.hash();
        }
        // [skipping-work.tests.spoilt.steps]
        found += differs ? 1 : 0;
        CHECK(std::abs(spoilt.energy() - before) < 1e-12 * before);
        CHECK(none.deepest() < 1e-12);
    }
    CHECK(found == 10);
}
// [skipping-work.tests.spoilt]


TEST_CASE("the engine on one page goes from impact to impact as the event engine does")
{
    PlainEngine plain(hexagons(121), Bound::right);
    EventEngine engine(hexagons(121), {});
    for (int k = 0; k < 100; ++k) REQUIRE(plain.step());
    CHECK_FALSE(engine.advance(plain.time(), 1'000'000).has_value());
    CHECK(engine.counts().impacts == 100);
    for (int k = 0; k < 9; ++k) {
        const BodyState a = state_at(engine.flyer(k), plain.time());
        const BodyState b = plain.state(k, plain.time());
        CHECK((a.position - b.position).norm() < 1e-6);
    }
}

