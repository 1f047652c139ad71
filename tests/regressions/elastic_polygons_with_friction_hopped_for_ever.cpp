// A polygon with e = 1 and friction, as in a scene that names friction alone, loses its bounces to friction within
// seconds. Once they were too low to be seen it came down on all of its corners at once, and lost nothing any more: it
// hopped on by less than a millionth of a micrometre, hundred thousands of times a second, in one of sixteen scenes for
// good.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "math/random.hpp"
#include "support/bodies.hpp"
#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("elastic polygons with friction come to rest without millions of impacts, and gain no energy")
{
    const int scenes = tried(64);
    for (int seed = 1; seed <= scenes; ++seed) {
        CAPTURE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        Scene scene = on_a_floor(1.0, random.uniform(0.02, 1.2));
        BodyDef body;
        body.shape = RegularDef{3 + static_cast<int>(random.below(6)), random.uniform(0.1, 1.0)};
        body.position = {0.0, random.uniform(1.1, 3.0)};
        body.angle = random.uniform(0.0, 6.0);
        body.spin = random.uniform(-3.0, 3.0);
        body.velocity = {random.uniform(-1.0, 1.0), 0.0};
        scene.bodies.push_back(body);
        World world = world_of(scene);
        run(world, 20.0);
        const Report report = world.report();
        CHECK(report.events <= 10000);
        CHECK(report.energy.kinetic + report.energy.potential <= report.initial_total * (1.0 + 1e-13));
    }
}

TEST_CASE("heaps of elastic boxes with friction take a hundred impacts for each body, not thousands, and come to rest")
{
    for (int seed = 1; seed <= tried(3); ++seed) {
        CAPTURE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        Scene scene;
        scene.world.field = UniformField{{0.0, -9.81}};
        scene.world.restitution = 1.0;
        scene.world.friction = 0.5;
        scene.world.box = BoxDef{{0.0, 0.0}, {9.0, 40.0}};
        std::vector<double> squares; // of the radii of gyration
        for (int k = 0; k < 80; ++k) {
            const double width = random.uniform(0.3, 0.8);
            const double height = random.uniform(0.3, 0.8);
            BodyDef body = rectangle(width, height, {0.6 + 0.97 * (k % 9), 0.6 + 1.15 * (k / 9)});
            body.angle = random.uniform(0.0, 3.0);
            body.mass = width * height;
            squares.push_back((width * width + height * height) / 12.0);
            scene.bodies.push_back(body);
        }
        World world = world_of(scene);
        run(world, 4.0);
        const Report report = world.report();
        CHECK(report.collisions <= 40000);
        CHECK(report.max_overlap <= 0.01 * 0.15);
        run(world, 12.0);

        // A box that rocks from corner to corner, and slips on neither, loses nothing: leave out the fastest
        std::vector<double> kinetic;
        for (int k = 0; k < 80; ++k) {
            const BodyState state = world.state(k);
            const double spin = state.spin * state.spin;
            kinetic.push_back(0.5 * *scene.bodies[k].mass * (state.velocity.squaredNorm() + spin * squares[k]));
        }
        std::sort(kinetic.begin(), kinetic.end());
        kinetic.pop_back();
        CHECK(std::accumulate(kinetic.begin(), kinetic.end(), 0.0) <= 1e-6 * report.initial_total);
    }
}

TEST_CASE("an elastic box that falls flat bounces for ever, with friction and without")
{
    for (const double friction : {0.0, 0.4}) {
        Scene scene = on_a_floor(1.0, friction);
        scene.bodies.push_back(rectangle(1.0, 0.5, {0.0, 2.0}));
        World world = world_of(scene);
        run(world, 60.0);
        const Report report = world.report();
        CHECK(world.mover(1) == BodyMover::events);
        CHECK(std::abs(report.energy.kinetic + report.energy.potential - report.initial_total) <=
              1e-12 * report.initial_total);
    }
}
