// Heaps of more than 64 bodies of very unequal masses crept for ever, by millimetres a second, and never slept: in a
// slow heap, sweeps were content with approaches that were faster than what counts as rest.

#include <cmath>

#include "math/random.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("more than half of the heaps of masses over 1 : 1e4 sleep within 20 s, and none has sunk")
{
    int asleep = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Scene scene;
        scene.world.field = UniformField{{0.0, -9.81}};
        scene.world.restitution = 0.0;
        scene.world.friction = 0.5;
        scene.world.box = BoxDef{{0.0, 0.0}, {9.0, 200.0}};
        for (int k = 0; k < 100; ++k) {
            BodyDef body = disc(0.42, {0.5 + (k % 9) + random.uniform(-0.05, 0.05), 0.5 + 0.95 * (k / 9)});
            body.mass = std::pow(1e4, random.uniform(0.0, 1.0));
            scene.bodies.push_back(body);
        }
        World world = world_of(scene);
        run(world, 20.0);
        CHECK(deepest_overlap(world) <= 0.01 * 0.42);
        int awake = 0;
        for (int k = 0; k < world.body_count(); ++k) awake += world.mover(k) != BodyMover::asleep ? 1 : 0;
        if (awake == 0) ++asleep;
    }
    CHECK(asleep >= 5); // 6 of them; none before
}
