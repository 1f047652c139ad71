// Elastic bodies without friction that fill a pit to the last digit took hours for a step: a blow ran to and fro among
// them without end, as it must where nothing has room to give way, and was followed for 4096 rounds in each of 256
// parts of the step. With gaps of a billionth of a body and less they bounced to and fro in flight, a billion times a
// second. Now a blow that doesn't end is turned round by the forces of the contacts, over all of what is left of the
// step; and what bounces between others with next to no room, more often than can be followed, is the resting
// integrator's.

#include <cmath>
#include <string>

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

enum class Kind
{
    box,
    disc,
    hexagon
};

struct Pit
{
    Kind kind;
    int columns;
    int rows;
    double gap;     // [m]
    double gravity; // [m/s^2]
    double mass;    // of the disc that strikes [kg]
    double speed;   // the same [m/s]
};

constexpr double k_width = 0.6; // [m]

/// Bodies with equal gaps between each other and the walls, and a disc that strikes them from above.
Scene scene_of(const Pit& pit)
{
    const double width = pit.columns * k_width + (pit.columns + 1) * pit.gap;
    const double height = pit.kind == Kind::hexagon ? 2.0 * k_width / std::sqrt(3.0) : k_width;
    Scene scene;
    if (pit.gravity > 0.0) scene.world.field = UniformField{{0.0, -pit.gravity}};
    scene.world.restitution = 1.0;
    scene.world.friction = 0.0;
    scene.world.box = BoxDef{{0.0, 0.0}, {width, 30.0}};
    double top = 0.0;
    for (int row = 0; row < pit.rows; ++row) {
        for (int column = 0; column < pit.columns; ++column) {
            const Vec2 position(pit.gap + 0.5 * k_width + column * (k_width + pit.gap),
                                pit.gap + 0.5 * height + row * (height + pit.gap));
            BodyDef body =
                pit.kind == Kind::disc ? disc(0.5 * k_width, position) : rectangle(k_width, k_width, position);
            if (pit.kind == Kind::hexagon) {
                body.shape = RegularDef{6, 0.5 * height};
                body.angle = std::acos(-1.0) / 6.0;
            }
            body.mass = 0.36;
            scene.bodies.push_back(body);
            top = position.y() + 0.5 * height;
        }
    }
    BodyDef striker = disc(0.25, {0.5 * width + 0.07, top + 0.75});
    striker.mass = pit.mass;
    striker.velocity = Vec2(0.3, -pit.speed);
    scene.bodies.push_back(striker);
    return scene;
}

} // namespace

TEST_CASE("elastic bodies that fit a pit to the last digit, or nearly, keep their energy and take few impacts")
{
    for (const Pit& pit :
         tried({Pit{Kind::box, 4, 3, 1e-9, 0.0, 30.0, 20.0}, Pit{Kind::box, 4, 6, 0.0, 9.81, 3.0, 5.0},
                Pit{Kind::disc, 7, 9, 0.0, 9.81, 3.0, 5.0}, Pit{Kind::box, 3, 6, 1e-15, 9.81, 0.3, 5.0},
                Pit{Kind::hexagon, 7, 4, 0.0, 0.0, 30.0, 5.0}, Pit{Kind::box, 2, 6, 1e-12, 9.81, 3.0, 5.0},
                Pit{Kind::hexagon, 3, 3, 1e-12, 0.0, 0.3, 20.0}, Pit{Kind::disc, 4, 3, 1e-9, 9.81, 30.0, 1.0},
                Pit{Kind::box, 4, 3, 1e-6, 9.81, 3.0, 5.0}})) {
        CAPTURE(static_cast<int>(pit.kind));
        CAPTURE(pit.gap);
        World world = world_of(scene_of(pit));

        // What a pit takes in a second: followed to the end these made ten million impacts and more, or billions
        for (int k = 1; k <= 15; ++k) {
            (void)world.advance(0.1 * k, 1000000);
            REQUIRE(world.time() == 0.1 * k);
        }
        const Report report = world.report();
        CHECK(report.collisions <= 1500000);
        CHECK(std::abs(report.energy.total() - report.initial_total) <= 1e-9 * report.initial_total);
        CHECK(report.max_overlap <= 0.01 * 0.5 * k_width);
    }
}

TEST_CASE("a light elastic box between a wall and a heavy one is followed to the end, however near they come")
{
    // Masses of 1 and 100^n make as many impacts as the first n + 1 digits of pi say
    Scene scene;
    scene.world.restitution = 1.0;
    scene.world.friction = 0.0;
    scene.world.box = BoxDef{{0.0, 0.0}, {1000.0, 1.0}};
    BodyDef light = rectangle(1.0, 0.5, {2.0, 0.5});
    light.mass = 1.0;
    BodyDef heavy = rectangle(1.0, 0.5, {5.0, 0.5});
    heavy.mass = 1e10;
    heavy.velocity = Vec2(-1.0, 0.0);
    scene.bodies = {light, heavy};
    World world = world_of(scene);
    run(world, 40.0);
    CHECK(world.report().collisions == 314159);
    CHECK(world.handovers().empty());
}

TEST_CASE("an elastic body without friction that hops lower than can be seen goes on hopping")
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = 1.0;
    scene.world.friction = 0.0;
    scene.bodies.push_back(still(rectangle(40.0, 1.0, {0.0, -0.5})));
    scene.bodies.push_back(rectangle(1.0, 0.5, {0.0, 0.25 + 1e-9}));
    World world = world_of(scene);
    run(world, 2.0);
    CHECK(world.handovers().empty());
    CHECK(world.report().collisions >= 60000);
}
