// A wall or a pyramid that is all there from the start, of more than 64 bodies, was swept like a heap that lands. It
// sank until its impulses had grown, by 4 % of a brick in a wall of 16 by 20, and shook for a second; one of 50 by 60
// took ten seconds of computing for each of the first two. Its forces are found by turns now, in the first step. Where
// some bricks weighed a hundred times as much as others, that led nowhere at first, and such walls still sank.

#include <algorithm>
#include <cmath>

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// What a floor bears that is tilted.
Scene floor(double tilt, double friction)
{
    Scene scene = on_a_floor(0.0, friction);
    scene.world.field = UniformField{9.81 * Vec2(std::sin(tilt), -std::cos(tilt))};
    return scene;
}

/// Bricks in rows, every other shifted by half a brick. Where `unlike` is over 1, every third weighs that much more.
Scene wall(int columns, int rows, double tilt, double friction, double unlike)
{
    Scene scene = floor(tilt, friction);
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k < columns; ++k) {
            scene.bodies.push_back(rectangle(0.4, 0.2, {0.4 * (k + 0.5 * (row % 2)), 0.1 + 0.2 * row}));
            scene.bodies.back().mass = (k + row) % 3 == 0 ? unlike : 1.0;
        }
    }
    return scene;
}

/// Boxes, each on two of the row below, which stand apart.
Scene pyramid(int rows, double tilt, double friction)
{
    Scene scene = floor(tilt, friction);
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k < rows - row; ++k)
            scene.bodies.push_back(rectangle(1.0, 1.0, {1.06 * (k + 0.5 * row), 0.5 + row}));
    }
    return scene;
}

/// How far any body gets from its place.  [m]
double worst_way(const Scene& scene, double until)
{
    World world = world_of(scene);
    run(world, until);
    double worst = 0.0;
    for (int k = 0; k < world.body_count(); ++k)
        worst = std::max(worst, (world.state(k).position - scene.bodies[k].position).norm());
    return worst;
}

} // namespace

TEST_CASE("what is built and not poured doesn't move by a bit")
{
    for (const Scene& scene :
         tried({wall(16, 20, 0.0, 0.6, 1.0), wall(12, 12, 0.0, 0.3, 1.0), wall(8, 25, 0.0, 0.3, 10.0),
                wall(20, 30, 0.0, 0.6, 1.0), wall(21, 10, 0.0, 0.26, 270.0), wall(21, 14, 0.0, 0.89, 238.0),
                wall(27, 32, 0.0, 0.64, 95.0), wall(12, 12, 0.0, 0.5, 2000.0), pyramid(30, 0.0, 0.5),
                pyramid(40, 0.2, 0.6), pyramid(25, 0.1, 0.3)})) {
        CAPTURE(scene.bodies.size());
        CHECK(worst_way(scene, 0.5) == 0.0);
    }
}
