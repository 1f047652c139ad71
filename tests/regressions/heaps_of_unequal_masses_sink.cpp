// Heaps of more than 64 bodies whose masses differ sank into each other and through the floor: so many sweeps as they
// had hardly move what is heavy and lies on what is light.

#include <cmath>

#include "math/random.hpp"
#include "support/heaps.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("heaps of unequal masses keep apart by a hundredth of their size")
{
    struct Case
    {
        int count;
        double heaviest; // [kg]
        std::uint64_t seed;
    };
    for (const Case& each : {Case{140, 1e1, 3}, Case{81, 1e2, 8}, Case{140, 1e3, 5}, Case{81, 1e4, 3}}) {
        CAPTURE(each.count);
        CAPTURE(each.heaviest);
        World world = world_of(heap_of_unequal_masses(each.count, each.heaviest, each.seed));
        REQUIRE_FALSE(world.advance(8.0).has_value());
        CHECK(deepest_overlap(world) < 0.01);
    }
}

TEST_CASE("small heaps keep apart, too, where the heaviest lie on the lightest")
{
    // 24 boxes, each heavier than the one that was laid before, with bodies of 1 kg at the bottom
    for (const double heaviest : {1e6, 1e9}) {
        CAPTURE(heaviest);
        Scene scene;
        scene.world.field = UniformField{{0.0, -9.81}};
        scene.world.restitution = 0.0;
        scene.world.friction = 0.5;
        scene.world.box = BoxDef{{0.0, 0.0}, {5.0, 30.0}};
        Random random(3);
        for (int k = 0; k < 24; ++k) {
            BodyDef body = rectangle(0.7, 0.6, {0.5 + 0.95 * (k % 5), 0.5 + 1.0 * (k / 5)});
            body.angle = random.uniform(0.0, 3.0);
            body.mass = std::pow(heaviest, k / 23.0);
            scene.bodies.push_back(body);
        }
        World world = world_of(scene);
        REQUIRE_FALSE(world.advance(6.0).has_value());
        CHECK(deepest_overlap(world) < 0.01);
    }
}
