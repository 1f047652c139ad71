// A disc that spun at 1000 rad/s on a heap of boxes made each step of all of them in 64 parts, as a box that turns so
// fast would need: 20 times the work, and a turn doesn't bring a disc's rim anywhere.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Islands that steps were made for, in three seconds of boxes that lie in a pyramid, and discs that land on it.
[[nodiscard]] std::int64_t islands_below(double spin, double friction, int rows)
{
    Scene scene = on_a_floor(0.2, friction);
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k < rows - row; ++k)
            scene.bodies.push_back(rectangle(1.0, 1.0, {1.05 * (k - 0.5 * (rows - row - 1)), row + 0.5}));
    }
    for (const double x : {-1.2, 0.3, 1.8}) {
        scene.bodies.push_back(disc(0.3, {x, rows + 1.0}));
        scene.bodies.back().spin = spin;
    }
    World world = world_of(scene);
    run(world, 3.0);
    return world.report().rest.value_or(RestAccount{}).islands;
}

} // namespace

TEST_CASE("a heap on which discs spin takes as many steps as one on which they don't")
{
    for (const double friction : {0.0, 0.5}) {
        const std::int64_t still = islands_below(0.0, friction, 5);
        for (const double spin : tried({-1000.0, 200.0, 50.0})) {
            CAPTURE(friction);
            CAPTURE(spin);
            CHECK(islands_below(spin, friction, 5) < 6 * still);
        }
    }
}

TEST_CASE("a disc that spins fast in a corner is braked evenly, to the moment at which it stands")
{
    for (const double friction : {0.3, 1.2}) {
        for (const double spin : tried({1000.0, 300.0, 40.0})) {
            CAPTURE(friction);
            CAPTURE(spin);
            const double radius = 0.1;
            Scene scene = on_a_floor(0.0, friction);
            scene.bodies.push_back(still(rectangle(1.0, 20.0, {-0.5 - radius, 9.0})));
            scene.bodies.push_back(disc(radius, {0.0, radius}));
            scene.bodies.back().spin = spin;
            World world = world_of(scene);

            // Floor and wall bear m g / (1 + mu^2) and mu times as much, and both brake
            const double brake = 2.0 * friction * (1.0 + friction) * 9.81 / (radius * (1.0 + friction * friction));
            double worst = 0.0;
            for (int k = 1; k <= 120; ++k) {
                run(world, k / 60.0);
                worst = std::max(worst, std::abs(world.state(2).spin - std::max(0.0, spin - brake * k / 60.0)));
            }
            CHECK(worst <= 1e-12 * spin);
        }
    }
}
