// A box or a ball that fell along a wall it touched, or in a shaft that it fits, took up to a second of computing for
// each that was simulated. The search for its impacts took gravity for something that may press it against the wall,
// and so it met a graze every microsecond. A wall doesn't turn, and what falls along it comes no nearer.

#include <cmath>
#include <vector>

#include "support/bodies.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A body at a height of 8 m, between walls that are further apart than its width by a gap.
Scene shaft(const BodyDef& body, double gap, double friction, double upwards)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.friction = friction;
    scene.bodies = {still(rectangle(1.0, 30.0, {-0.5, 10.0})), still(rectangle(1.0, 30.0, {1.5 + gap, 10.0})), body};
    scene.bodies.back().position = {0.5, 8.0};
    scene.bodies.back().velocity = {0.0, upwards};
    return scene;
}

} // namespace

TEST_CASE("what falls along a wall is looked at a few times a second, and falls freely")
{
    BodyDef triangle = rectangle(1.0, 1.0, Vec2::Zero());
    triangle.shape = PolygonDef{{{-0.5, -0.3}, {0.5, -0.3}, {0.0, 0.6}}, {}};
    const std::vector<BodyDef> bodies = {rectangle(1.0, 0.5, Vec2::Zero()), disc(0.5, Vec2::Zero()), triangle};
    for (const BodyDef& body : bodies) {
        for (const double gap : {0.0, 1e-12, 1e-9}) {
            for (const double friction : {0.0, 0.5}) {
                for (const double upwards : {0.0, 5.0}) {
                    CAPTURE(gap);
                    World world = world_of(shaft(body, gap, friction, upwards));
                    run(world, 1.0);
                    CHECK(std::abs(world.state(2).position.y() - (8.0 + upwards - 0.5 * 9.81)) <= 1e-13);
                    CHECK(world.report().events <= 100);
                }
            }
        }
    }
}
