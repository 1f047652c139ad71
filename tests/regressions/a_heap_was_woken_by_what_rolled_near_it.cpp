// A heap of 300 discs, of which one had rolled out and went on at half a millimetre a second, a centimetre from the
// others, was solved anew in every step, for ever: all the others slept, and woke in each step since it was near. Where
// masses differ, such a search takes more than the time that it is for.

#include <cstdint>

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

[[nodiscard]] std::int64_t islands_of(World& world)
{
    return world.report().rest.value_or(RestAccount{}).islands;
}

/// A column of boxes that lie on each other, and a disc that rolls towards it.
[[nodiscard]] Scene column_and_disc(int boxes, double radius, double gap, double speed)
{
    Scene scene = on_a_floor(0.0, 0.5);
    for (int k = 0; k < boxes; ++k) scene.bodies.push_back(rectangle(1.0, 1.0, {0.5, k + 0.5}));
    scene.bodies.push_back(disc(radius, {-radius - gap, radius}, {speed, 0.0}));
    scene.bodies.back().spin = -speed / radius;
    return scene;
}

} // namespace

TEST_CASE("what sleeps is left alone while a disc rolls slowly near it")
{
    for (const int boxes : {1, 20, 80}) {
        for (const double speed : tried({5e-4, -5e-4, 2e-3, 1e-4})) {
            CAPTURE(boxes);
            CAPTURE(speed);
            World world = world_of(column_and_disc(boxes, 0.42, 0.01, speed));
            run(world, 1.0);
            const std::int64_t before = islands_of(world);
            run(world, 3.0);
            CHECK(islands_of(world) - before <= 121); // one for the disc in each step
        }
    }
}

TEST_CASE("what sleeps wakes when a disc that rolled slowly near it comes to touch it")
{
    for (const double speed : tried({5e-3, 0.02, 0.1})) {
        for (const double restitution : {0.0, 0.5, 1.0}) {
            CAPTURE(speed);
            CAPTURE(restitution);
            Scene scene = on_a_floor(restitution, 0.0);
            scene.bodies.push_back(disc(0.42, {0.42, 0.42}));
            scene.bodies.push_back(disc(0.42, {-0.43, 0.42}, {speed, 0.0}));
            scene.bodies[scene.bodies.size() - 2].mass = scene.bodies.back().mass = 2.0;
            World world = world_of(scene);
            run(world, 1.0 + 0.01 / speed);
            const int last = world.body_count() - 1;
            const double struck = 0.5 * (1.0 + restitution) * speed;
            CHECK(world.state(last - 1).velocity.x() == doctest::Approx(struck).epsilon(1e-9));
            CHECK(world.state(last).velocity.x() == doctest::Approx(speed - struck).epsilon(1e-9));
        }
    }
}
