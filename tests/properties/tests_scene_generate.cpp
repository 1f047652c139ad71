// Generated scenes: fit to run for many seeds and options, the same for the same seed, and faults for what can't be.

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "math/random.hpp"
#include "scene/fault.hpp"
#include "scene/generate.hpp"
#include "scene/generate_words.hpp"
#include "scene/write.hpp"

using namespace flying;

namespace {

/// Drawn options of the sort that the kind takes; mostly possible.
GenerateOptions random_options(Random& random, const std::string& kind)
{
    GenerateOptions options;
    options.seed = random.bits();
    const auto chance = [&] { return random.below(2) == 0; };
    const bool swarm = kind == "balls" || kind == "gas" || kind == "polygons" || kind == "pile";
    if (kind != "billiard" && chance()) options.count = 1 + random.below(kind == "pyramid" ? 8 : 60);
    if (swarm && chance()) {
        const double least = random.uniform(0.01, 0.15);
        options.radius = Bounds{least, least * random.uniform(1.0, 2.0)};
    }
    if (swarm && kind != "pile" && chance()) options.speed = Bounds{0.0, random.uniform(0.0, 9.0)};
    if (swarm && kind != "pile" && !options.speed && chance()) options.rms_speed = random.uniform(0.0, 9.0);
    if (swarm && kind != "pile" && chance()) options.max_spin = random.uniform(0.0, 9.0);
    if (swarm && chance()) options.packing = random.uniform(0.01, 0.15);
    if (swarm && !options.packing && chance()) options.box = BoxDef{Vec2(-20.0, -10.0), Vec2(20.0, 90.0)};
    if (kind != "cradle" && kind != "billiard" && chance()) options.gravity = Vec2(random.uniform(-1.0, 1.0), -9.81);
    if (kind != "billiard" && chance()) options.restitution = random.uniform();
    if (kind != "billiard" && chance()) options.density = random.uniform(0.1, 100.0);
    if (kind == "gas") options.shape = std::vector<std::string>{"disc", "polygon", "dumbbell"}[random.bits() % 3];
    if (kind == "pile") options.shape = std::vector<std::string>{"disc", "polygon", "box"}[random.bits() % 3];
    if (kind == "polygons" && chance()) options.min_sides = 3 + random.below(10);
    if (kind == "stack" && chance()) options.mass_ratio = random.uniform(0.01, 1e4);
    if ((kind == "stack" || kind == "pyramid" || kind == "cradle") && chance()) options.gap = random.uniform(0.0, 0.9);
    if (kind == "billiard") options.billiard = chance() ? "pi" : "rectangle";
    if (kind == "billiard" && *options.billiard == "pi" && chance()) options.exponent = random.below(9);
    return options;
}

std::string faults_of(const std::string& kind, const GenerateOptions& options)
{
    const Expected<Scene> scene = generate(kind, options);
    return scene ? std::string() : format_faults(scene.faults());
}

double area_of_discs(const Scene& scene)
{
    double area = 0.0;
    for (const BodyDef& body : scene.bodies) {
        const double radius = std::get<DiscDef>(body.shape).radius;
        area += 3.141592653589793 * radius * radius;
    }
    return area;
}

} // namespace

TEST_CASE("Every kind makes scenes that are fit to run, whatever the seed")
{
    Random random(31);
    for (const GeneratorKind& kind : generator_kinds()) {
        for (int round = 0; round < 60; ++round) {
            const GenerateOptions options = random_options(random, kind.name);
            const Expected<Scene> scene = generate(kind.name, options);
            INFO(kind.name, " seed ", options.seed);
            INFO((scene ? std::string() : format_faults(scene.faults())));
            REQUIRE(scene);
            CHECK(validate(scene.value()).empty());
            CHECK(!scene.value().title.empty());
        }
    }
}

TEST_CASE("Without options every kind makes its scene, and the same seed makes the same")
{
    for (const GeneratorKind& kind : generator_kinds()) {
        const Expected<Scene> one = generate(kind.name, {});
        const Expected<Scene> two = generate(kind.name, {});
        REQUIRE(one);
        REQUIRE(two);
        CHECK(write_scene(one.value()) == write_scene(two.value()));
        const bool is_drawn =
            kind.name == "balls" || kind.name == "gas" || kind.name == "polygons" || kind.name == "pile";
        GenerateOptions other;
        other.seed = 2;
        const Expected<Scene> three = generate(kind.name, other);
        REQUIRE(three);
        if (is_drawn) CHECK(write_scene(one.value()) != write_scene(three.value()));
    }
}

TEST_CASE("A gas has the packing and the speed asked for, up to dense lattices and ten thousand discs")
{
    for (const double packing : {0.001, 0.1, 0.3, 0.5, 0.7, 0.85}) {
        for (const int count : {1, 2, 3, 10, 1000, 10000}) {
            // Few discs leave much of a square box empty
            if (packing > 0.3 && count < 1000) continue;
            GenerateOptions options;
            options.count = count;
            options.packing = packing;
            const Expected<Scene> scene = generate("gas", options);
            INFO(packing, " ", count);
            REQUIRE(scene);
            REQUIRE(scene.value().bodies.size() == static_cast<std::size_t>(count));
            const BoxDef& box = *scene.value().world.box;
            const Vec2 size = box.max - box.min;

            // Sums of `count` terms, each rounded
            CHECK(area_of_discs(scene.value()) / (size.x() * size.y()) == doctest::Approx(packing).epsilon(1e-11));
            double sum = 0.0;
            for (const BodyDef& body : scene.value().bodies) sum += body.velocity.squaredNorm();
            CHECK(std::sqrt(sum / count) == doctest::Approx(5.0).epsilon(1e-11));
        }
    }
}

TEST_CASE("Radii and speeds of balls keep within their bounds")
{
    GenerateOptions options;
    options.radius = Bounds{0.05, 0.4};
    options.speed = Bounds{1.0, 1.5};
    options.seed = 5;
    const Expected<Scene> scene = generate("balls", options);
    REQUIRE(scene);
    CHECK(scene.value().bodies.size() == 100);
    for (const BodyDef& body : scene.value().bodies) {
        const double radius = std::get<DiscDef>(body.shape).radius;
        const double speed = body.velocity.norm();
        CHECK(radius >= 0.05);
        CHECK(radius < 0.4);
        CHECK(speed >= 1.0 - 1e-15);
        CHECK(speed < 1.5 + 1e-15);
    }
}

TEST_CASE("What can't be generated is refused with its reason, all reasons at once")
{
    GenerateOptions options;
    CHECK(faults_of("gass", options)
              .starts_with("kind: found \"gass\", expected one of balls, gas, polygons, pile, stack, "
                           "pyramid, cradle, billiard (did you mean gas?)"));

    options.packing = 0.95;
    CHECK(faults_of("gas", options).starts_with("packing: found 1000 bodies in circles"));
    options.box = BoxDef{Vec2(0.0, 0.0), Vec2(1.0, 1.0)};
    CHECK(faults_of("gas", options) == "packing: found box as well, expected one of the two\n");
    options.packing.reset();
    CHECK(faults_of("balls", options).starts_with("box: found 100 bodies in circles"));

    options = {};
    options.radius = Bounds{2.0, 1.0};
    options.speed = Bounds{-1.0, 1.0};
    options.count = 0;
    options.restitution = 1.5;
    options.gap = 1.0;
    const std::string faults = faults_of("balls", options);
    INFO(faults);
    CHECK(faults.find("radius: found 2.0 ... 1.0, expected 0 < min <= max\n") != std::string::npos);
    CHECK(faults.find("speed: found -1.0 ... 1.0, expected 0 <= min <= max\n") != std::string::npos);
    CHECK(faults.find("count: found 0, expected a whole number, 1 ... 1000000\n") != std::string::npos);
    CHECK(faults.find("restitution: found 1.5, expected a number, 0 ... 1\n") != std::string::npos);
    CHECK(faults.find("gap: found an option that balls does not know, expected one of seed, count") !=
          std::string::npos);

    options = {};
    options.min_sides = 6;
    options.max_sides = 5;
    CHECK(faults_of("polygons", options) == "min_sides: found 6, expected at most max_sides, 5\n");
    CHECK(faults_of("gas", options) == "min_sides: found 6, expected at most max_sides, 5\n");

    options = {};
    options.shape = "dumbel";
    CHECK(faults_of("gas", options) ==
          "shape: found \"dumbel\", expected one of disc, polygon, dumbbell (did you mean dumbbell?)\n");

    options = {};
    options.radius = Bounds{1.0, 2.0};
    CHECK(faults_of("cradle", options) == "radius: found 1.0 ... 2.0, expected one value: min = max\n");

    options = {};
    options.billiard = "rectangle";
    options.radius = Bounds{5.0, 5.0};
    CHECK(faults_of("billiard", options) ==
          "radius: found a ball wider than its box, expected 2 radius < width, height\n");
    options.exponent = 2;
    CHECK(!faults_of("billiard", options).empty());
}

TEST_CASE("Numbers that are none, and extreme ones, end in a scene or in faults")
{
    const double extremes[] = {std::nan(""), INFINITY, -INFINITY, 0.0,  -0.0,  5e-324,
                               1e-60,        1e-30,    1e30,      1e60, 1e308, -1.0};
    for (const GeneratorKind& kind : generator_kinds()) {
        for (const double x : extremes) {
            for (int option = 0; option < 10; ++option) {
                GenerateOptions options;
                options.count = kind.name == "billiard" ? std::nullopt : std::optional(5);
                if (option == 0) options.radius = Bounds{x, x};
                if (option == 1) options.speed = Bounds{x, x};
                if (option == 2) options.rms_speed = x;
                if (option == 3) options.packing = x;
                if (option == 4) options.box = BoxDef{Vec2(0.0, 0.0), Vec2(x, 1.0)};
                if (option == 5) options.gravity = Vec2(x, x);
                if (option == 6) options.gap = x;
                if (option == 7) options.mass_ratio = x;
                if (option == 8) options.radius = Bounds{1e-60, x};
                if (option == 9) options.density = x;
                const Expected<Scene> scene = generate(kind.name, options);
                if (scene) CHECK(validate(scene.value()).empty());
            }
        }
    }
}

TEST_CASE("a scene is not written where its text would be too large to be read, and as many bodies as are told fit")
{
    constexpr std::size_t k_largest = 20000; // [bytes]
    for (const std::string kind : {"balls", "gas", "polygons", "pile", "stack", "cradle"}) {
        CAPTURE(kind);
        GenerateOptions options;
        options.count = 1000;
        if (kind != "stack" && kind != "cradle") options.packing = 0.2;
        const Expected<std::string> refused = generate_text(kind, options, "", k_largest);
        REQUIRE_FALSE(refused);
        const Fault& fault = refused.faults().front();
        CHECK(fault.place == "count");
        CHECK(fault.found.starts_with("1000 bodies, a scene of "));
        const std::string before = "at most 20000 bytes: ";
        REQUIRE(fault.expected.starts_with(before));
        options.count = std::stoi(fault.expected.substr(before.size()));
        CHECK(*options.count >= 50);
        CHECK(generate_text(kind, options, "", k_largest));
    }
}
