// While they fell and rolled, polygons in heaps of more than 64 got into each other by 4 to 20 % of their size: sweeps
// lead points along straight ways, and what turns leaves those. And where a corner of one was wedged in between two
// others, it was found a sixth of a size deep in one that it hardly touched.

#include <algorithm>

#include "math/random.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

// Bounding radii  [m]
constexpr double k_least_radius = 0.25;
constexpr double k_most_radius = 0.4;

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
                                random.uniform(k_least_radius, k_most_radius)};
        body.position = {0.5 + (k % 6) + random.uniform(-0.05, 0.05), 0.5 + 1.0 * (k / 6)};
        body.angle = random.uniform(0.0, 6.0);
        body.spin = random.uniform(-8.0, 8.0);
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace

TEST_CASE("polygons that fall in a heap keep apart by a hundredth of their size on the way, and lie so in the end")
{
    struct Case
    {
        int count;
        int corners;
        double restitution;
        double friction;
        std::uint64_t seed;
    };
    // Measured over twelve heaps in each of seven engines that differed in a bit or a few: on the way 0.0027 of the
    // smallest radius in the median, 0.0083 at worst of 84; at the end 0.0013 and 0.0044 of the smaller one's. Of the
    // smaller one's, and not of the smallest, a step of a heap may leave 0.0078
    std::vector<double> on_the_way;
    for (const Case& each : {Case{70, 0, 0.2, 0.5, 11}, Case{70, 4, 0.0, 0.3, 12}, Case{70, 3, 0.5, 0.8, 13},
                             Case{70, 5, 0.0, 0.0, 14}, Case{70, 0, 0.2, 0.5, 21}, Case{70, 5, 0.0, 0.0, 24}}) {
        CAPTURE(each.corners);
        CAPTURE(each.seed);
        World world = world_of(rain(each.count, each.corners, each.restitution, each.friction, each.seed));
        // Four times in each step, so that no two get by
        for (int k = 1; k <= 720; ++k) {
            REQUIRE_FALSE(world.advance(k / 240.0).has_value());
            CHECK(deepest_overlap(world) < 0.01);
        }
        on_the_way.push_back(world.report().max_overlap / k_least_radius);
    }
    std::sort(on_the_way.begin(), on_the_way.end());
    CHECK(on_the_way[2] < 0.005);
    CHECK(on_the_way[4] < 0.01);
    CHECK(on_the_way[5] < 0.01 * k_most_radius / k_least_radius);
}
