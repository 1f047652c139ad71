// In one of ten heaps of 60 to 90 bodies a last disc went on rolling to and fro, and forces were looked for by Newton's
// method alone: what sweeps had left was so much that the others didn't count as standing. It found none in any step,
// and all crept for as long as one watched. So did one of twenty heaps of boxes of which some weigh a hundred or a
// thousand times as much as others: what sweeps leave there is faster.

#include <cmath>
#include <cstdint>

#include "math/random.hpp"
#include "support/effort.hpp"
#include "support/heaps.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Discs, triangles and rectangles that drop into a box, eight in a row.
Scene mixed_drop(int count, double friction, std::uint64_t seed)
{
    Random random(seed);
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = 0.3;
    scene.world.friction = friction;
    scene.world.box = BoxDef{{0.0, 0.0}, {4.0, 0.5 * (count / 8 + 4)}};
    for (int k = 0; k < count; ++k) {
        const Vec2 place(0.25 + 0.5 * (k % 8), 0.55 + 0.45 * (k / 8));
        const double size = random.uniform(0.13, 0.19);
        BodyDef body;
        if (const int kind = random.below(3); kind == 0) body = disc(size, place);
        else if (kind == 1) body = rectangle(1.6 * size, 1.2 * size, place);
        else {
            body.shape = PolygonDef{{{size, 0.0}, {-0.5 * size, 0.87 * size}, {-0.5 * size, -0.87 * size}}, {}};
            body.position = place;
        }
        body.angle = random.uniform(0.0, 6.0);
        body.velocity = Vec2(random.uniform(-0.5, 0.5), 0.0);
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace

TEST_CASE("forces are found in a heap on which a body rolls to and fro")
{
    for (const std::uint64_t seed : tried<std::uint64_t>({7, 10, 18, 23, 35})) {
        CAPTURE(seed);
        const int count = 60 + 4 * static_cast<int>(seed % 8);
        World world = world_of(mixed_drop(count, 0.3 + 0.02 * static_cast<double>(seed % 12), seed));
        run(world, 7.0);
        const std::int64_t until_then = world.report().rest.value().unsolved;
        run(world, 8.0);
        CHECK(world.report().rest.value().unsolved - until_then < 6);
    }
}

namespace {

/// Boxes that drop into a box, eight in a row; their masses are spread evenly by powers of ten.
///
/// heaviest  against the lightest, which may have 1 kg [kg]
Scene unequal_boxes(int count, double heaviest, std::uint64_t seed)
{
    Random random(seed);
    Scene scene = rough_pit({9.7, 40.0});
    for (int k = 0; k < count; ++k) {
        const Vec2 place(0.6 + 1.2 * (k % 8) + random.uniform(-0.03, 0.03), 0.7 + 1.2 * (k / 8));
        const double width = random.uniform(0.3, 0.8);
        BodyDef body = rectangle(width, random.uniform(0.3, 0.8), place);
        body.angle = random.uniform(0.0, 3.0);
        body.mass = std::pow(heaviest, random.uniform(0.0, 1.0));
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace

TEST_CASE("forces are found in heaps of unequal boxes before they lie")
{
    for (const std::uint64_t seed : tried<std::uint64_t>({29, 31, 51, 53})) {
        CAPTURE(seed);
        const double heaviest = seed % 2 == 0 ? 100.0 : 1000.0;
        World world = world_of(unequal_boxes(70 + 10 * static_cast<int>(seed % 3), heaviest, seed));
        run(world, 13.0);
        const std::int64_t until_then = world.report().rest.value().unsolved;
        run(world, 15.0);
        CHECK(world.report().rest.value().unsolved - until_then < 12);
    }
}
