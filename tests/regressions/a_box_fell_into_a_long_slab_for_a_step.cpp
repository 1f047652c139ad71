// A box that slid down a long slab, given as a turned polygon, fell into it for a whole step as it passed the middle of
// the world: there its coordinates are small, and what rounding leaves of distances was taken for as small, though the
// slab's vertices are tens of metres away.

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/random.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A rectangle about the origin, turned before its vertices are written down.
PolygonDef turned(double width, double height, double angle)
{
    PolygonDef polygon;
    const Vec2 along(std::cos(angle), std::sin(angle));
    const Vec2 up(-along.y(), along.x());
    for (const auto& [x, y] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}})
        polygon.vertices.push_back(x * width * along + y * height * up);
    return polygon;
}

} // namespace

TEST_CASE("a box that slides down a slab of any length never leaves it nor sinks in near the origin")
{
    Random random(41);
    for (const double length : {20.0, 60.0, 200.0, 600.0}) {
        for (int k = 0; k < 20; ++k) {
            const double angle = random.uniform(-0.6, 0.6);
            const double height = random.uniform(0.2, 0.6);
            const Vec2 along(std::cos(angle), std::sin(angle));
            const Vec2 up(-along.y(), along.x());
            Scene scene;
            scene.world.field = UniformField{{0.0, -9.81}};
            scene.world.restitution = 0.0;
            scene.world.friction = 0.2 * std::abs(std::tan(angle));
            BodyDef slab;
            slab.shape = turned(length, 1.0, angle);
            slab.position = random.uniform(-1.0, 1.0) * along - 0.5 * up;
            slab.is_static = true;
            BodyDef box;
            box.shape = turned(random.uniform(0.3, 1.0), height, angle);
            box.position = 0.5 * height * up;
            scene.bodies = {slab, box};
            World world = world_of(scene);
            CAPTURE(length);
            CAPTURE(angle);
            double fastest = 0.0;
            for (int step = 1; step <= 45; ++step) {
                REQUIRE_FALSE(world.advance(step / 60.0).has_value());
                fastest = std::max(fastest, std::abs(world.state(1).velocity.dot(up)));
            }
            CHECK(fastest < 1e-9);
        }
    }
}
