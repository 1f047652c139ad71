// At e = 1 without friction, bodies that touch at the start lost a tenth of their energy and more, and no report said so: they
// bounce more often than a step can follow. What is lost is told now, to where it went.

#include <cmath>

#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Discs at rest, packed in a box, and a ball that falls on them.
Scene pit(int count, int columns, double mass)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = 1.0;
    scene.world.box = BoxDef{{0.0, 0.0}, {static_cast<double>(columns), 40.0}};
    int row = 0;
    for (int left = count; left > 0; ++row) {
        const bool is_even = row % 2 == 0;
        for (int k = 0; k < (is_even ? columns : columns - 1) && left > 0; ++k, --left)
            scene.bodies.push_back(disc(0.5, {(is_even ? 0.5 : 1.0) + k, 0.5 + row * std::sqrt(0.75)}));
    }
    BodyDef ball = disc(0.5, {0.5 * columns + (columns > 1 ? 0.3 : 0.0), 3.5 + row * std::sqrt(0.75)});
    ball.mass = mass;
    scene.bodies.push_back(ball);
    return scene;
}

} // namespace

TEST_CASE("elastic bodies without friction keep their energy, or the report says what took it")
{
    bool any_kept = false;
    bool any_lost = false;
    struct Case {
        int count;
        int columns;
        double mass;
    };
    for (const Case& each : {Case{1, 1, 1.0}, Case{2, 2, 3.0}, Case{5, 3, 1.0}, Case{12, 5, 3.0}, Case{38, 8, 3.0}}) {
        CAPTURE(each.count);
        World world = world_of(pit(each.count, each.columns, each.mass));
        run(world, 2.0);
        const Report report = world.report();
        const double lost = report.initial_total - report.energy.total();
        const RestAccount rest = report.rest.value();
        if (std::abs(lost) <= 1e-9 * report.initial_total) {
            any_kept = true;
            CHECK(report.warnings.empty());
            continue;
        }
        any_lost = true;
        REQUIRE(report.warnings.size() == 1);
        CHECK(report.warnings[0].find("lost at e = 1 without friction") != std::string::npos);
        // All of it: what the limit took had been gained in the same steps
        CHECK(rest.elastic_ended + rest.elastic_braked >= (1.0 - 1e-9) * lost);
        CHECK(rest.elastic_ended + rest.elastic_braked <= lost + rest.energy_limited + 1e-9 * report.initial_total);
    }
    CHECK(any_kept);
    CHECK(any_lost);
}

TEST_CASE("where friction or impacts may take energy, nothing is warned of")
{
    Scene scene = pit(12, 5, 3.0);
    scene.world.friction = 0.5;
    World rubs = world_of(scene);
    run(rubs, 1.0);
    CHECK(rubs.report().warnings.empty());
    scene.world.friction = 0.0;
    scene.world.restitution = 0.9;
    World bounces = world_of(scene);
    run(bounces, 1.0);
    CHECK(bounces.report().warnings.empty());
}
