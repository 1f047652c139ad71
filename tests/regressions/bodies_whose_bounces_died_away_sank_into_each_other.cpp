#include "support/worlds.hpp"

#include <algorithm>

#include "collide/separation.hpp"
#include "math/random.hpp"

using namespace flying;
using namespace flying::testing;

// Where turning brings two bodies together again after each bounce, bounces follow each other ever faster. Each of the last
// ones left the corner a quarter of a tolerance deeper, and when it lay too deep to count as touching, no more impacts were
// seen: the two flew on through each other.

namespace {

/// Two bodies that turn, and meet with little speed, in no field.
Scene two_that_turn(std::uint64_t seed, double restitution)
{
    Random random(seed);
    Scene scene;
    scene.world.restitution = restitution;
    scene.world.friction = random.uniform(0.0, 1.0);
    const double size = random.uniform(0.3, 1.0);
    BodyDef one = seed % 2 == 0 ? disc(1.0, {0.0, 0.0}) : rectangle(2.0, random.uniform(0.3, 2.0), {0.0, 0.0});
    BodyDef two = rectangle(1.4 * size, 1.4 * size * random.uniform(0.1, 1.0), {0.0, 1.6 + size});
    for (BodyDef* body : {&one, &two}) {
        body->angle = random.uniform(-3.0, 3.0);
        body->spin = random.uniform(-1.5, 1.5);
        body->density = random.uniform(0.1, 10.0);
    }
    two.velocity = Vec2(random.uniform(-0.2, 0.2), -random.uniform(0.2, 1.0));
    scene.bodies = {one, two};
    return scene;
}

double deepest(const Scene& scene)
{
    World world = world_of(scene);
    double overlap = 0.0;
    for (int k = 1; k <= 60; ++k) {
        run(world, 0.1 * k);
        const double gap = separation(make_collision_shape(world.shape(0)), pose_of(world.state(0)),
                                      make_collision_shape(world.shape(1)), pose_of(world.state(1)));
        overlap = std::max(overlap, -gap);
    }
    return overlap;
}

} // namespace

TEST_CASE("two bodies that turn, and bounce off each other ever faster, never overlap")
{
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        for (const double restitution : {0.0, 0.2, 0.5, 0.8}) {
            CAPTURE(seed);
            CAPTURE(restitution);
            CHECK(deepest(two_that_turn(seed, restitution)) < 1e-9);
        }
    }
}
