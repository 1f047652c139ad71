// Where a groove could also hold a disc by wedging it, one disc in 200 that spun there stopped at once. Newton's
// guesses went round, and the search that came next began from inside the cones of friction, whatever had borne in the
// step before; both answers keep Coulomb's law, and it found the other one.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/random.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("a disc that spins in a groove that could wedge it is braked by both planes")
{
    constexpr double k_g = 9.81;
    Random random(4711);
    for (int tried = 0; tried < 200;) {
        const double left = random.uniform(0.05, 1.5);
        const double right = random.uniform(0.05, 1.5);
        const double mu = random.uniform(0.1, 10.0);
        const double spin = random.uniform(10.0, 60.0);
        // The line from one contact to the other lies in both cones, and with slip both planes press
        const bool may_wedge = std::tan(0.5 * (std::numbers::pi - left - right)) <= mu;
        const Vec2 a(std::sin(left) - mu * std::cos(left), std::cos(left) + mu * std::sin(left));
        const Vec2 b(-std::sin(right) - mu * std::cos(right), std::cos(right) - mu * std::sin(right));
        const double push_left = -b.x() / cross(a, b); // over the weight
        const double push_right = a.x() / cross(a, b);
        if (!may_wedge || std::min(push_left, push_right) < 0.01) continue;
        ++tried;
        CAPTURE(left);
        CAPTURE(right);
        CAPTURE(mu);

        Scene scene;
        scene.world.field = UniformField{{0.0, -k_g}};
        scene.world.restitution = 0.0;
        scene.world.friction = mu;
        for (const double lean : {-left, right}) {
            BodyDef plane = rectangle(4.0, 1.0, Rotation::of(lean) * Vec2(0.0, -1.5));
            plane.angle = lean;
            scene.bodies.push_back(still(plane));
        }
        scene.bodies.push_back(disc(1.0, {0.0, 0.0}));
        scene.bodies.back().spin = spin;
        World world = world_of(scene);
        run(world, 0.5 * spin / (2.0 * mu * (push_left + push_right) * k_g));
        CHECK(std::abs(world.state(2).spin - 0.5 * spin) < 1e-9 * spin);
    }
}
