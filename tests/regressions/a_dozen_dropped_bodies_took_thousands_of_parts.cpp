#include "support/effort.hpp"
#include "support/worlds.hpp"

#include <cmath>

#include "math/random.hpp"

using namespace flying;
using namespace flying::testing;

// A dozen boxes or polygons that landed on each other took up to 0.11 s for a simulated second, more than two dozens
// do. A blow to a body that lies on two corners opens one of them by some millionths of a millimetre, and each such gap
// got a moment of its own, with two looks and a solve; where it would close was reckoned along a straight line, so that
// it took several moments to get there; and in a short part of a step, slower and slower approaches counted as blows.

namespace {

/// Bodies of one kind, at random angles, in rows over a floor between walls.
Scene dropped(int corners, double restitution, std::uint64_t seed)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = restitution;
    scene.world.friction = 0.5;
    scene.world.box = BoxDef{{0.0, 0.0}, {3.0, 10.0}};
    Random random(seed);
    for (int k = 0; k < 12; ++k) {
        BodyDef body;
        body.shape = RegularDef{corners, random.uniform(0.25, 0.4)};
        body.position = {0.5 + k % 3, 0.5 + k / 3};
        body.angle = random.uniform(0.0, 6.0);
        scene.bodies.push_back(body);
    }
    return scene;
}

} // namespace

TEST_CASE("a dozen bodies that are dropped on each other are struck some times in a step, not dozens of times")
{
    std::int64_t parts = 0;
    int scenes = 0;
    for (const int corners : {4, 5, 6}) {
        for (const double restitution : {0.0, 0.3}) {
            for (int seed = 1; seed <= tried(5); ++seed, ++scenes) {
                World world = world_of(dropped(corners, restitution, static_cast<std::uint64_t>(seed)));
                run(world, 3.0);
                const Report report = world.report();
                REQUIRE(report.rest.has_value());
                CHECK(report.max_overlap <= 0.01 * 0.25);
                parts += report.rest->parts;
            }
        }
    }
    const double seconds = 3.0 * scenes;
    INFO((static_cast<double>(parts) / seconds));
    CHECK(static_cast<double>(parts) <= 1300.0 * seconds);
}
