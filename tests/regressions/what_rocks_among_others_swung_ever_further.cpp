// A plank that rocks on a disc goes on as it began. Where the two lay among so many others that their ways weren't
// followed along curves, each step pushed along the lines that it had begun with: in twenty seconds the plank turned
// six times as fast.

#include <algorithm>
#include <cmath>

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A disc in the gap between two rows of heavy boxes, and a plank on it.
Scene rocker(int boxes, double thickness, double spin)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = 0.0;
    scene.world.friction = 1.0;
    scene.bodies.push_back(still(rectangle(100.0, 1.0, {0.0, -0.5})));
    for (int k = 0; k < boxes; ++k) {
        for (const double side : {-1.0, 1.0}) {
            scene.bodies.push_back(rectangle(1.0, 1.0, {side * (0.8 + k), 0.5}));
            scene.bodies.back().density = 100.0;
        }
    }
    scene.bodies.push_back(disc(0.5, {0.0, 1.4}));
    scene.bodies.push_back(rectangle(0.8, thickness, {0.0, 1.9 + 0.5 * thickness}));
    scene.bodies.back().spin = spin;
    return scene;
}

} // namespace

TEST_CASE("a plank that rocks among others goes on to rock as far")
{
    struct Case
    {
        int boxes;        // on each side
        double thickness; // [m]
        double spin;      // [rad/s]
    };
    for (const Case& each : tried({Case{1, 0.2, 1.0}, Case{3, 0.2, 0.5}, Case{3, 0.4, 1.0}, Case{4, 0.3, 0.8},
                                   Case{6, 0.2, 0.5}, Case{6, 0.4, 1.0}, Case{10, 0.2, 0.5}, Case{10, 0.4, 0.5},
                                   Case{33, 0.2, 0.5}, Case{40, 0.4, 1.0}, Case{32, 0.3, 0.8}})) {
        CAPTURE(each.boxes);
        CAPTURE(each.thickness);
        World world = world_of(rocker(each.boxes, each.thickness, each.spin));
        const int plank = 2 * each.boxes + 2;
        const auto fastest = [&](double until) {
            double top = 0.0;
            while (world.time() < until - 0.01) {
                REQUIRE_FALSE(world.advance(world.time() + 1.0 / 60.0).has_value());
                top = std::max(top, std::abs(world.state(plank).spin));
            }
            return top;
        };
        const double first = fastest(3.0);
        (void)fastest(17.0);
        const double last = fastest(20.0);
        CHECK(last < 1.01 * first);
        CHECK(last > 0.95 * first);
    }
}
