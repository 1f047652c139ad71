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
