// Two static slabs that overlap with their tops level, or a floor that was given twice, threw back what landed on a
// corner as no one slab does: in flight its two equal points were taken for two, and at rest for two bodies.

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/random.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

BodyDef slab(double x, double width)
{
    BodyDef body = rectangle(width, 1.0, {x, -0.5});
    body.is_static = true;
    return body;
}

/// Something falls at an angle, on one slab or on several.
Scene fall(const BodyDef& body, const std::vector<BodyDef>& floor, double restitution, double friction)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    scene.bodies = floor;
    scene.bodies.push_back(body);
    return scene;
}

BodyState landed(const Scene& scene, EngineChoice engine)
{
    World world = world_of(scene, engine);
    run(world, 0.7);
    return world.state(static_cast<int>(scene.bodies.size()) - 1);
}

double difference(const BodyState& a, const BodyState& b)
{
    return std::max((a.position - b.position).norm(), std::abs(a.angle - b.angle));
}

} // namespace

TEST_CASE("what lands on slabs that overlap bounces as from one slab, whatever it is and with either engine")
{
    Random random(29);
    const std::vector<std::vector<BodyDef>> floors = {
        {slab(-4.0, 10.0), slab(4.0, 10.0)}, {slab(0.0, 20.0), slab(0.0, 20.0)}, {slab(3.0, 30.0), slab(0.0, 2.0)}};
    for (const double restitution : {0.3, 0.6, 1.0}) {
        for (const double friction : {0.0, 0.1, 0.4, 1.0}) {
            for (int k = 0; k < 4; ++k) {
                BodyDef body = rectangle(1.0, k % 2 == 0 ? 1.0 : 0.3, {random.uniform(-0.9, 0.9), 2.0});
                if (k == 3) body.shape = RegularDef{6, 0.5};
                body.angle = random.uniform(0.1, 1.4);
                body.velocity = {random.uniform(-2.0, 2.0), 0.0};
                for (const EngineChoice engine : {EngineChoice::automatic, EngineChoice::rest}) {
                    const BodyState one = landed(fall(body, {slab(0.0, 20.0)}, restitution, friction), engine);
                    for (const std::vector<BodyDef>& floor : floors) {
                        CAPTURE(restitution);
                        CAPTURE(friction);
                        CAPTURE(k);
                        CHECK(difference(one, landed(fall(body, floor, restitution, friction), engine)) < 1e-6);
                    }
                }
            }
        }
    }
}
