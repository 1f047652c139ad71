#include <doctest/doctest.h>

#include "support/worlds.hpp"

// At e < 1 the event engine went on through a thousand impacts at one moment before it gave a body that had come to rest
// to the resting integrator: a pentagon dropped at e = 0 reported 1003 collisions.

using namespace flying;
using namespace flying::testing;

namespace {

BodyDef pentagon(double angle, double spin)
{
    BodyDef body;
    body.shape = RegularDef{5, 0.3};
    body.position = {0.0, 2.0};
    body.velocity = {0.5, 0.0};
    body.angle = angle;
    body.spin = spin;
    return body;
}

Scene over_floor(double restitution, double friction)
{
    Scene scene;
    scene.until = 5.0;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    scene.world.box = BoxDef{{-5.0, 0.0}, {5.0, 10.0}};
    return scene;
}

} // namespace

TEST_CASE("a body that lands at e = 0 is handed over at its first impact, which is one collision")
{
    for (int k = 0; k < 30; ++k) {
        Scene scene = over_floor(0.0, 0.1 * (k % 7));
        scene.bodies = {pentagon(0.21 * k, 0.3 * k - 4.0)};
        World world = world_of(scene);
        double landed = 0.0;
        for (int i = 1; landed == 0.0 && i <= 200; ++i) {
            REQUIRE_FALSE(world.advance(0.005 * i).has_value());
            if (!world.handovers().empty()) landed = world.handovers().front().time;
        }
        INFO("case " << k);
        REQUIRE(landed > 0.0);
        CHECK(world.collisions() == 1);
        CHECK(world.handovers().front().bodies == std::vector<int>{0});
        CHECK(world.handovers().front().energy_change == 0.0);
        CHECK(world.handovers().front().reason.find("an impact leaves body 0 and the floor on each other") == 0);
    }
}

TEST_CASE("bounces that die away end in a hand-over after some dozens of collisions")
{
    for (int k = 0; k < 24; ++k) {
        const double e[] = {0.2, 0.4, 0.6, 0.7};
        Scene scene = over_floor(e[k % 4], k % 3 == 0 ? 0.0 : 0.4);
        scene.bodies = {pentagon(0.17 * k, 0.2 * k)};
        World world = world_of(scene);
        REQUIRE_FALSE(world.advance(scene.until).has_value());
        INFO("case " << k << ": " << world.collisions() << " collisions, " << world.handovers().size() << " hand-overs");
        CHECK(world.collisions() < 250);
    }
}

TEST_CASE("what bounces without loss is not handed over, however low it hops")
{
    Scene scene = over_floor(1.0, 0.0);
    BodyDef box = rectangle(0.4, 0.2, {0.0, 0.1 + 1e-3});
    scene.bodies = {box};
    World world = world_of(scene);
    REQUIRE_FALSE(world.advance(scene.until).has_value());
    CHECK(world.handovers().empty());
    CHECK(world.collisions() > 100);
}
