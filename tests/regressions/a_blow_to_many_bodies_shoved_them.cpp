// A disc that fell on the middle of a column of 13 boxes and more shoved them aside, by millimetres to metres, though no
// line of push led sideways; and a pyramid of five rows and more that was struck in the middle lost its symmetry. In an
// island of more than twelve bodies a blow was ended by a few sweeps: what they left of it became load, and overlap.

#include <algorithm>
#include <cmath>

#include "support/bodies.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Rows of boxes, each one shorter by so many than the one below, and a disc that falls on the middle of the last.
Scene struck_rows(int rows, int in_first, int fewer, double restitution, double friction)
{
    Scene scene;
    scene.world.field = UniformField{Vec2(0.0, -9.81)};
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    scene.bodies.push_back(still(rectangle(20.0, 1.0, {0.0, -0.5})));
    for (int row = 0; row < rows; ++row) {
        const int count = in_first - fewer * row;
        for (int k = 0; k < count; ++k)
            scene.bodies.push_back(rectangle(0.5, 0.5, {0.625 * (k - 0.5 * (count - 1)), 0.25 + 0.5 * row}));
    }
    BodyDef ball = disc(0.25, {0.0, 0.5 * rows + 1.0}, {0.0, -5.0});
    ball.mass = 4.0;
    scene.bodies.push_back(ball);
    return scene;
}

/// How far any box gets within a second.  [m]
double farthest(const Scene& scene)
{
    Expected<World> made = World::make(scene, WorldOptions());
    REQUIRE(made.has_value());
    World& world = made.value();
    double far = 0.0;
    for (int k = 1; k <= 60; ++k) {
        REQUIRE_FALSE(world.advance(k / 60.0).has_value());
        for (std::size_t body = 1; body + 1 < scene.bodies.size(); ++body)
            far = std::max(far, (world.state(static_cast<int>(body)).position - scene.bodies[body].position).norm());
    }
    return far;
}

} // namespace

TEST_CASE("a column that a disc falls on stands whatever its height")
{
    for (const int boxes : {12, 13, 30, 70}) {
        for (const double friction : {0.0, 0.5}) {
            CAPTURE(boxes);
            CAPTURE(friction);
            CHECK(farthest(struck_rows(boxes, 1, 0, 0.0, friction)) < 1e-9);
        }
        CHECK(farthest(struck_rows(boxes, 1, 0, 0.5, 0.5)) < 1e-9);
    }
}

TEST_CASE("a pyramid that a disc falls on stands whatever its height")
{
    for (const int rows : {4, 5, 8}) {
        for (const double friction : {0.0, 0.5}) {
            CAPTURE(rows);
            CAPTURE(friction);
            CHECK(farthest(struck_rows(rows, rows, 1, 0.0, friction)) < 1e-9);
        }
        CHECK(farthest(struck_rows(rows, rows, 1, 0.2, 0.5)) < 1e-9);
    }
}
