#include "support/worlds.hpp"

#include <cmath>
#include <vector>

#include "math/random.hpp"

using namespace flying;
using namespace flying::testing;

// Where most bodies are elastic, and all are smooth, one in two hundred such boxes had bodies that sank into each other
// by a tenth of their size and more. Bodies that bounce without loss go back to flight though others are near.
// Some of them overlapped by a two-thousandth of their size then, which the steps would have taken off; in flight, what
// overlaps and still approaches meets nothing that would stop it.

namespace {

/// Discs, squares and hexagons in rows, in a box that stands askew; one in four is no more elastic than it happens to
/// be.
Scene tilted_box(std::uint64_t seed)
{
    Random random(seed);
    const int columns = 3 + random.below(3);
    const int count = 8 + 4 * random.below(4);
    const int rows = (count + columns - 1) / columns;
    const double tilt = random.uniform(-1.2, 1.2);
    Scene scene;
    scene.world.field = UniformField{{9.81 * std::sin(tilt), -9.81 * std::cos(tilt)}};
    scene.world.restitution = 1.0;
    scene.world.friction = 0.0;
    scene.world.box = BoxDef{{0.0, 0.0}, {1.6 * columns + 0.2, 1.6 * rows + 2.0}};
    for (int k = 0; k < count; ++k) {
        BodyDef body;
        const int kind = random.below(3);
        if (kind == 0) body.shape = DiscDef{0.5};
        else if (kind == 1) body.shape = RectangleDef{0.9, 0.9};
        else body.shape = RegularDef{6, 0.6};
        body.position = {0.9 + 1.6 * (k % columns), 0.8 + 1.6 * (k / columns)};
        if (random.below(2) == 0) body.angle = random.uniform(0.0, 6.0);
        if (random.below(4) == 0) body.restitution = random.uniform();
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace

TEST_CASE("elastic bodies that overlap a little when they are let go don't fly through each other")
{
    std::vector<std::uint64_t> seeds = {258, 406, 589}; // of 600 boxes, those that had overlaps of 3 to 9 cm
    for (std::uint64_t seed = 1; seed <= 40; ++seed) seeds.push_back(seed);
    for (const std::uint64_t seed : seeds) {
        CAPTURE(seed);
        World world = world_of(tilted_box(seed));
        run(world, 6.0);
        CHECK(world.report().max_overlap <= 0.01 * 0.5); // of the smallest bounding circle
    }
}
