// A polygon that struck the floor with a corner and without rebound went on otherwise in the resting engine than in
// flight, where friction turned its slip round, or held it: the one solved for the end of the impact alone, the other
// goes by the law of two bodies, which knows of the way there.

#include <cmath>
#include <numbers>

#include "math/random.hpp"
#include "support/bodies.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("a corner that strikes without rebound leaves alike in flight and at rest")
{
    Random random(71);
    int compared = 0;
    for (int k = 0; k < 200; ++k) {
        const int corners = 3 + static_cast<int>(random.uniform(0.0, 6.0));
        const double flat = random.uniform(0.5, 1.0);
        PolygonDef polygon;
        for (int i = 0; i < corners; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / corners;
            polygon.vertices.push_back({std::cos(turn), flat * std::sin(turn)});
        }
        BodyDef body = rectangle(1.0, 1.0, Vec2(0.0, 1.2), Vec2(random.uniform(-3.0, 3.0), random.uniform(-3.0, -0.5)));
        body.shape = polygon;
        body.angle = random.uniform(0.0, 2.0 * std::numbers::pi);
        body.spin = random.uniform(-8.0, 8.0);
        Scene scene;
        scene.world.field = UniformField{{0.0, 0.0}};
        scene.world.restitution = 0.0;
        scene.world.friction = random.uniform(0.0, 1.0);
        scene.bodies = {still(rectangle(40.0, 1.0, Vec2(0.0, -0.5))), body};

        // Up to the first impact, and a little further; what the events meet in a crowd there is no matter of this test
        World flight = events_of(scene);
        World rest = world_of(scene, EngineChoice::rest);
        for (int step = 1; step <= 120; ++step) {
            if (flight.advance(step / 240.0).has_value()) break;
            REQUIRE_FALSE(rest.advance(step / 240.0).has_value());
            const BodyState flown = flight.state(1);
            if (flown.velocity == body.velocity && flown.spin == body.spin) continue;
            CAPTURE(k);
            CAPTURE(scene.world.friction);
            const BodyState rested = rest.state(1);
            CHECK((flown.velocity - rested.velocity).norm() < 1e-6);
            CHECK(std::abs(flown.spin - rested.spin) < 1e-6);
            ++compared;
            break;
        }
    }
    CHECK(compared > 50);
}
