#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/worlds.hpp"

// Asked between two steps, the world made a shorter step of its own and told where that led: energies jumped by a hundredth
// and rose again, and dominoes overlapped by millimetres that never did so at a step's end.

using namespace flying;
using namespace flying::testing;

namespace {

constexpr double k_step = 1.0 / 60.0;

Scene dominoes(double friction)
{
    Scene scene;
    scene.until = 2.5;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = 0.0;
    scene.world.friction = friction;
    scene.world.box = BoxDef{{-1.0, 0.0}, {8.0, 10.0}};
    for (int k = 0; k < 10; ++k) scene.bodies.push_back(rectangle(0.2, 1.0, {0.5 * k, 0.5}));
    scene.bodies[0].spin = -1.5;
    scene.bodies[0].velocity = {0.75, 0.0};
    return scene;
}

double energy_of(World& world) { return world.report().energy.total(); }

} // namespace

TEST_CASE("asked as often as one likes, energy neither jumps nor rises beyond what a turn within a step hides")
{
    for (const double friction : {0.1, 0.3, 0.6}) {
        const Scene scene = dominoes(friction);
        World world = world_of(scene);
        const double start = energy_of(world);
        double before = start;
        double least = start;
        double worst = 0.0;
        for (int k = 1; k <= 600; ++k) {
            REQUIRE_FALSE(world.advance(k / 240.0).has_value());
            const double now = energy_of(world);
            worst = std::max(worst, now - least);
            least = std::min(least, now);
            before = now;
        }
        INFO("friction " << friction << ", rise " << worst << " of " << start);
        CHECK(worst <= 5e-4 * start);
        CHECK(before < start);
    }
}

TEST_CASE("to ask within steps changes no bit of a run")
{
    const Scene scene = dominoes(0.3);
    World never = world_of(scene);
    REQUIRE_FALSE(never.advance(scene.until).has_value());
    for (const double every : {0.02, 1.0 / 240.0, 0.0177}) {
        World often = world_of(scene);
        for (int k = 1; k * every < scene.until; ++k) {
            REQUIRE_FALSE(often.advance(k * every).has_value());
            for (int body = 0; body < often.body_count(); ++body) (void)often.state(body);
        }
        REQUIRE_FALSE(often.advance(scene.until).has_value());
        CHECK(often.report().hash == never.report().hash);
    }
}

TEST_CASE("whether asked once within a step or a dozen times, each moment has one answer")
{
    const Scene scene = dominoes(0.3);
    World often = world_of(scene);
    for (int k = 1; k <= 500; ++k) {
        const double time = 1.0 + 0.00123 * k;
        REQUIRE_FALSE(often.advance(time).has_value());
        if (k % 25 != 0) continue;
        World once = world_of(scene);
        REQUIRE_FALSE(once.advance(time).has_value());
        for (int body = 0; body < often.body_count(); ++body) {
            CHECK(once.state(body).position == often.state(body).position);
            CHECK(once.state(body).velocity == often.state(body).velocity);
            CHECK(once.state(body).angle == often.state(body).angle);
        }
    }
}

TEST_CASE("the way within a step leads from its start to its end")
{
    for (const EngineChoice engine : {EngineChoice::automatic, EngineChoice::rest}) {
        World world = world_of(dominoes(0.3), engine);
        for (int step = 30; step < 120; ++step) {
            REQUIRE_FALSE(world.advance(step * k_step).has_value());
            std::vector<BodyState> start;
            for (int body = 0; body < world.body_count(); ++body) start.push_back(world.state(body));
            REQUIRE_FALSE(world.advance((step + 1e-7) * k_step).has_value());
            for (int body = 0; body < world.body_count(); ++body) {
                CHECK((world.state(body).position - start[body].position).norm() <= 1e-7);
            }
            REQUIRE_FALSE(world.advance((step + 1 - 1e-7) * k_step).has_value());
            std::vector<BodyState> last;
            for (int body = 0; body < world.body_count(); ++body) last.push_back(world.state(body));
            REQUIRE_FALSE(world.advance((step + 1) * k_step).has_value());
            for (int body = 0; body < world.body_count(); ++body) {
                CHECK((world.state(body).position - last[body].position).norm() <= 1e-7);
            }
        }
    }
}
