// A disc that spins in the corner of floor and wall with a friction above 1 got no force at all for a dozen frames, fell
// at -g t without moving, and was then struck a blow.

#include <cmath>
#include <numbers>

#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

constexpr double k_g = 9.81;     // [m/s^2]
constexpr double k_spin = 40.0;  // [rad/s]
constexpr double k_frame = 1.0 / 60.0;

struct Corner
{
    double friction;
    double radius; // [m]
    double mass;   // [kg]
    double tilt;   // of gravity, towards the wall [rad]
    double side;   // of the wall: -1 left, 1 right
};

Scene scene_of(const Corner& corner)
{
    Scene scene;
    scene.world.field = UniformField{{corner.side * k_g * std::sin(corner.tilt), -k_g * std::cos(corner.tilt)}};
    scene.world.restitution = 0.0;
    scene.world.friction = corner.friction;
    scene.world.box = BoxDef{{-4.0, 0.0}, {4.0, 8.0}};
    BodyDef body = disc(corner.radius, {corner.side * (4.0 - corner.radius), corner.radius});
    body.mass = corner.mass;
    body.spin = -corner.side * k_spin;
    scene.bodies = {body};
    return scene;
}

/// Both contacts slip: two equations for two forces. The spin falls so fast.  [rad/s^2]
double braking(const Corner& corner)
{
    const double mu = corner.friction;
    const double down = k_g * std::cos(corner.tilt);
    const double towards_wall = k_g * std::sin(corner.tilt);
    const double floor = (down - mu * towards_wall) / (1.0 + mu * mu);
    const double wall = mu * floor + towards_wall;
    REQUIRE(floor > 0.0);
    return 2.0 * mu * (floor + wall) / corner.radius;
}

void check(const Corner& corner)
{
    CAPTURE(corner.friction);
    CAPTURE(corner.radius);
    CAPTURE(corner.tilt);
    CAPTURE(corner.side);
    World world = world_of(scene_of(corner));
    const Vec2 start = world.state(0).position;
    const double stop = k_spin / braking(corner); // [s]
    const auto frames = static_cast<int>(stop / k_frame);
    // Rounding of the coordinates of a body 4 m from the origin, over a hundred steps
    const double still = 1e-12 * corner.radius + 1e-13;
    for (int frame = 1; frame <= frames; ++frame) {
        REQUIRE_FALSE(world.advance(frame * k_frame).has_value());
        const BodyState now = world.state(0);
        CHECK(-corner.side * now.spin == doctest::Approx(k_spin - braking(corner) * frame * k_frame).epsilon(1e-9));
        CHECK((now.position - start).norm() < still);
        CHECK(now.velocity.norm() < 1e-9 * k_g * k_frame);
    }
    REQUIRE_FALSE(world.advance((frames + 3) * k_frame).has_value());
    CHECK(world.state(0).spin == 0.0);
    CHECK((world.state(0).position - start).norm() < still);
}

} // namespace

TEST_CASE("a disc that spins in a corner is braked as Coulomb's law says, whatever the friction")
{
    for (const double friction : {0.3, 0.9, 1.0, 1.05, 1.2, 1.5, 2.0, 5.0, 10.0}) {
        for (const double side : {-1.0, 1.0}) {
            check({friction, 0.1, 1.0, 0.0, side});
            check({friction, 0.37, 12.5, 0.0, side});
        }
    }
}

TEST_CASE("a disc that spins in a leaning groove is braked as Coulomb's law says")
{
    for (const double friction : {0.5, 1.2, 3.0}) {
        for (const double part : {0.2, 0.6, 0.9}) {
            check({friction, 0.2, 2.0, part * std::atan(1.0 / friction), -1.0});
            check({friction, 0.2, 2.0, part * std::atan(1.0 / friction), 1.0});
        }
    }
}
