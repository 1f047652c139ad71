// A box that slid over a row of 64 bricks or more, or over a wall of as many, was tripped at the first seams, and
// thrown: with so many bodies in an island of which one moves, impulses were swept, and what sweeps leave makes steps
// of bricks that lay flush. Over 63 bricks it slid as over one slab.

#include <algorithm>
#include <cmath>

#include "math/random.hpp"
#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Bricks between two pillars, and a box on them at the left end.
Scene over_a_wall(int rows, int columns, const Vec2& brick, double friction, double restitution, const Vec2& box,
                  double speed)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.friction = friction;
    scene.world.restitution = restitution;
    const double top = rows * brick.y();
    const double length = columns * brick.x();
    for (const Vec2& middle : {Vec2(0.5 * length, -0.5), Vec2(-0.5, 0.5 * top), Vec2(length + 0.5, 0.5 * top)}) {
        const bool is_floor = middle.y() < 0.0;
        scene.bodies.push_back(rectangle(is_floor ? length + 2.0 : 1.0, is_floor ? 1.0 : top, middle));
        scene.bodies.back().is_static = true;
    }
    for (int row = 0; row < rows; ++row) {
        for (int k = 0; k < columns; ++k) {
            scene.bodies.push_back(
                rectangle(brick.x(), brick.y(), Vec2((k + 0.5) * brick.x(), (row + 0.5) * brick.y())));
        }
    }
    scene.bodies.push_back(rectangle(box.x(), box.y(), Vec2(0.5 * box.x(), top + 0.5 * box.y()), Vec2(speed, 0.0)));
    return scene;
}

} // namespace

TEST_CASE("a box slides over as many bricks as there are as over one slab")
{
    Random random(1809);
    for (int k = 0; k < tried(24); ++k) {
        const int rows = 1 + random.below(4);
        const int columns = (65 + random.below(40)) / rows + 1;
        const Vec2 brick(0.125 * (2 + random.below(4)), 0.125 * (1 + random.below(4)));
        const double friction = k % 3 == 0 ? 0.0 : random.uniform(0.1, 0.5);
        const double restitution = k % 2 == 0 ? 0.0 : random.uniform(0.0, 0.8);
        const Vec2 box(random.uniform(0.5, 2.0), random.uniform(0.2, 0.5));
        const double speed = random.uniform(1.0, 9.0);
        CAPTURE(k);
        CAPTURE(rows);
        CAPTURE(columns);
        const Scene scene = over_a_wall(rows, columns, brick, friction, restitution, box, speed);
        World world = world_of(scene, k % 4 == 3 ? EngineChoice::rest : EngineChoice::automatic);
        const double room = columns * brick.x() - box.x();
        const double until = std::min(1.5, 0.9 * room / speed);
        run(world, until);

        const double brake = friction * 9.81;
        const double time = brake * until > speed ? speed / brake : until; // until it stops
        // The step in which a slip ends is not made in parts in so large an island
        const double bound = brake * until > speed ? 1e-3 : 1e-9;
        const BodyState state = world.state(world.body_count() - 1);
        CHECK(std::abs(state.position.x() - (0.5 * box.x() + speed * time - 0.5 * brake * time * time)) < bound);
        CHECK(std::abs(state.position.y() - (rows * brick.y() + 0.5 * box.y())) < 1e-9);
        CHECK(std::abs(state.angle) < 1e-9);
    }
}
