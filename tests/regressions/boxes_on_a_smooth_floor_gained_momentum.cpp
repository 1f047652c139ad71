// Rough boxes that stood or lay beside each other on a smooth floor gained up to 1e-9 of their momentum: two that go
// together were taken for one surface, along which the floor was touched, and each leans by some 1e-10. And where one
// of them leant more, its corner was looked for at the far end of the floor.

#include <cmath>

#include "math/random.hpp"
#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("boxes that lean on each other keep their momentum along a smooth floor")
{
    for (const std::uint64_t seed : tried<std::uint64_t>({1, 2, 3, 4})) {
        Random random(seed);
        Scene scene;
        scene.world.field = UniformField{{0.0, -9.81}};
        scene.world.restitution = seed % 2 == 0 ? 0.5 : 0.0;
        scene.world.friction = random.uniform(0.2, 0.8);
        BodyDef floor = still(rectangle(2000.0, 2.0, {0.0, -1.0}));
        floor.friction = 0.0;
        scene.bodies = {floor};
        double sum = 0.0;
        for (int tower = 0; tower < 12; ++tower) {
            const double speed = tower % 2 == 0 ? 0.9 : -0.7;
            const double width = random.uniform(0.3, 0.6);
            const double height = random.uniform(0.3, 0.6);
            for (int k = 0; k < 6; ++k) {
                const double x = 1.6 * (tower - 6) + random.uniform(-0.05, 0.05);
                BodyDef box = rectangle(width, height, {x, (0.5 + k) * height}, {speed, 0.0});
                box.mass = std::pow(1e3, random.uniform());
                sum += *box.mass * std::abs(speed);
                scene.bodies.push_back(box);
            }
        }
        World world = world_of(scene);
        const double before = world.report().momentum.x();
        REQUIRE_FALSE(world.advance(3.0).has_value());
        CAPTURE(seed);
        CHECK(std::abs(world.report().momentum.x() - before) <= 1e-13 * sum);
    }
}
