// Boxes lay between four walls without play, in no field, and one was pushed: each echo of the push loses energy, and
// all of them come at once, so that nothing moves. But rounds of impacts went on at speeds below 1e-300, which have no
// digits left for an approach to lose, and their sweeps waited for a change smaller than zero: six minutes for a
// second.

#include <cmath>

#include "support/bodies.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("boxes without play between four walls come to rest at once when one of them is pushed")
{
    for (const double restitution : {0.1, 0.5, 0.9}) {
        for (const int count : {2, 3}) {
            for (const double friction : {0.0, 0.2, 1.0}) {
                Scene scene;
                scene.world.restitution = restitution;
                scene.world.friction = friction;
                const double half = 0.5 * count;
                for (int k = 0; k < count; ++k) scene.bodies.push_back(rectangle(1.0, 1.0, {k + 0.5 - half, 0.0}));
                scene.bodies.front().velocity = {1.0, 0.5};
                for (const double side : {-1.0, 1.0}) {
                    scene.bodies.push_back(still(rectangle(1.0, 3.0, {side * (half + 0.5), 0.0})));
                    scene.bodies.push_back(still(rectangle(2.0 * half, 1.0, {0.0, side})));
                }
                World world = world_of(scene);
                run(world, 0.3);
                CAPTURE(restitution);
                CAPTURE(count);
                CAPTURE(friction);
                CHECK(world.collisions() < 100000);
                for (int k = 0; k < count; ++k) {
                    const BodyState state = world.state(k);
                    CHECK(state.velocity.norm() < 1e-12);
                    CHECK((state.position - Vec2(k + 0.5 - half, 0.0)).norm() < 1e-12);
                }
            }
        }
    }
}

// Nor did they where some echo left a box so slow that the square of its speed has no digits: the search for its next
// impact never ended.
TEST_CASE("boxes without play between four walls come to rest whichever way one of them is pushed")
{
    for (const double restitution : {0.1, 0.15}) {
        for (const double friction : {0.7, 1.0}) {
            for (const Vec2& push : {Vec2(1.0, 0.4), Vec2(1.0, 0.3), Vec2(0.7, 0.5), Vec2(1.0, -0.6)}) {
                Scene scene;
                scene.world.restitution = restitution;
                scene.world.friction = friction;
                for (const double x : {-0.5, 0.5}) scene.bodies.push_back(rectangle(1.0, 1.0, {x, 0.0}));
                scene.bodies.front().velocity = push;
                for (const double side : {-1.0, 1.0}) {
                    scene.bodies.push_back(still(rectangle(1.0, 3.0, {side * 1.5, 0.0})));
                    scene.bodies.push_back(still(rectangle(2.0, 1.0, {0.0, side})));
                }
                World world = world_of(scene);
                run(world, 0.3);
                CHECK(world.state(0).velocity.norm() < 1e-12);
                CHECK(world.state(1).velocity.norm() < 1e-12);
            }
        }
    }
}
