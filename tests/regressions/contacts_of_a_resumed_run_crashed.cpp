#include <doctest/doctest.h>

#include "support/worlds.hpp"
#include "world/hybrid.hpp"

// Asked for its contacts before its first step, a run that went on from a snapshot read the list of pairs by an index that
// was empty: it crashed, or hid a contact behind a neighbour that was none.

using namespace flying;
using namespace flying::testing;

namespace {

/// Boxes that stand beside each other on a floor of tiles, which have seams, and slide.
Scene boxes_on_tiles()
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.friction = 0.1;
    scene.world.restitution = 0.0;
    for (int k = 0; k < 8; ++k) scene.bodies.push_back(still(rectangle(1.0, 1.0, {0.5 + k, -0.5})));
    for (int k = 0; k < 3; ++k) scene.bodies.push_back(rectangle(0.8, 0.8, {1.4 + 0.8 * k, 0.4}, {1.0, 0.0}));
    scene.bodies.push_back(rectangle(0.8, 0.8, {1.8, 1.2}, {1.5, 0.0}));
    return scene;
}

} // namespace

TEST_CASE("a run that goes on from a snapshot has the contacts that it had")
{
    const Scene scene = boxes_on_tiles();
    World world = world_of(scene);
    for (const double time : {0.25, 0.5, 1.0}) {
        run(world, time);
        REQUIRE(world.integrators().resting() != nullptr);
        const std::vector<RestContact> before = world.integrators().resting()->contacts();
        CHECK(before.size() >= 8);

        Expected<World> resumed = World::resume(scene, world.snapshot());
        REQUIRE(resumed.has_value());
        REQUIRE(resumed.value().integrators().resting() != nullptr);
        const std::vector<RestContact> after = resumed.value().integrators().resting()->contacts();
        REQUIRE(after.size() == before.size());
        for (std::size_t k = 0; k < before.size(); ++k) {
            CHECK(after[k].a == before[k].a);
            CHECK(after[k].b == before[k].b);
            CHECK(after[k].point == before[k].point);
            CHECK(after[k].normal == before[k].normal);
            CHECK(after[k].normal_force == before[k].normal_force);
        }
        CHECK(resumed.value().integrators().resting()->groups() == world.integrators().resting()->groups());
    }
}
