// While they fell and rolled, polygons in heaps of more than 64 got into each other by 4 to 20 % of their size: sweeps
// lead points along straight ways, and what turns leaves those. And where a corner of one was wedged in between two
// others, it was found a sixth of a size deep in one that it hardly touched.

#include <algorithm>

#include "math/random.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Bodies that turn, rained into a narrow box: regular polygons of so many corners, or of 3 to 7 where that is 0.
Scene rain(int count, int corners, double restitution, double friction, std::uint64_t seed)
{
    Random random(seed);
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    scene.world.box = BoxDef{{0.0, 0.0}, {6.0, 40.0}};
    for (int k = 0; k < count; ++k) {
        BodyDef body;
        body.shape = RegularDef{corners != 0 ? corners : 3 + static_cast<int>(random.uniform(0.0, 5.0)),
                                random.uniform(0.25, 0.4)};
        body.position = {0.5 + (k % 6) + random.uniform(-0.05, 0.05), 0.5 + 1.0 * (k / 6)};
        body.angle = random.uniform(0.0, 6.0);
        body.spin = random.uniform(-8.0, 8.0);
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace

TEST_CASE("polygons that fall in a heap keep apart by a hundredth of their size at every step")
{
    struct Case
    {
        int count;
        int corners;
        double restitution;
        double friction;
        std::uint64_t seed;
    };
    for (const Case& each :
         {Case{110, 0, 0.2, 0.5, 1}, Case{90, 4, 0.0, 0.3, 2}, Case{90, 3, 0.5, 0.8, 3}, Case{90, 5, 0.0, 0.0, 4}}) {
        CAPTURE(each.corners);
        World world = world_of(rain(each.count, each.corners, each.restitution, each.friction, each.seed));
        REQUIRE_FALSE(world.advance(3.0).has_value());
        CHECK(world.report().max_overlap < 0.01 * 0.25);
    }
}
