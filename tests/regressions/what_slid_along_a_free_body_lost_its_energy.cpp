// A disc or a block that slides along a rod which turns freely, with nothing under the two, was too slow by a hundredth
// of its way, and a tenth of its energy was gone where nothing may take any: by the line of push with which a step
// begins nothing presses on it, so that it was let go in each step, and struck again, without rebound, in the next.
// Half the step brought no better way.

#include <cmath>

#include "math/random.hpp"
#include "support/bodies.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A rod, and what slides along it; with the field, and its own velocity, all of it falls.
struct Ride
{
    bool is_disc = true;
    double rod_mass = 1e9;
    double friction = 0.0;
    double restitution = 0.0;
    double spin = 2.0;   ///< of the rod [rad/s]
    double angle = 0.0;  ///< of the rod [rad]
    double start = 0.5;  ///< from the middle of the rod [m]
    double slide = 1.5;  ///< along the rod [m/s]
    double radius = 0.2; ///< of the disc; half the height of the block [m]
    Vec2 gravity = Vec2::Zero();
    Vec2 velocity = Vec2::Zero();
};

constexpr double k_rod = 0.1; // half its height [m]
constexpr double k_time = 0.4;

Scene scene_of(const Ride& ride)
{
    Scene scene;
    scene.world.field = UniformField{ride.gravity};
    scene.world.restitution = ride.restitution;
    scene.world.friction = ride.friction;
    const Rotation turned = Rotation::of(ride.angle);
    const double height = k_rod + ride.radius;
    const Vec2 place = turned * Vec2(ride.start, height);
    const Vec2 velocity = ride.velocity + turned * Vec2(ride.slide - ride.spin * height, ride.spin * ride.start);
    BodyDef rod = rectangle(16.0, 2.0 * k_rod, Vec2::Zero(), ride.velocity);
    BodyDef bead = ride.is_disc ? disc(ride.radius, place, velocity)
                                : rectangle(4.0 * ride.radius, 2.0 * ride.radius, place, velocity);
    rod.mass = ride.rod_mass;
    bead.mass = 1.0;
    rod.angle = bead.angle = ride.angle;
    rod.spin = ride.spin;
    bead.spin = ride.is_disc ? 0.0 : ride.spin;
    scene.bodies = {rod, bead};
    return scene;
}

/// Where it is along the rod that nothing brakes: xi'' = w^2 xi - mu (2 w xi' - w^2 h).  [m]
double place_of(const Ride& ride)
{
    const double mu = ride.friction;
    const double shift = mu * (k_rod + ride.radius);
    const double out = ride.spin * (std::sqrt(1.0 + mu * mu) - mu);
    const double in = -ride.spin * (std::sqrt(1.0 + mu * mu) + mu);
    const double both = ride.start + shift;
    const double second = (ride.slide - out * both) / (in - out);
    return (both - second) * std::exp(out * k_time) + second * std::exp(in * k_time) - shift;
}

World ridden(const Ride& ride, double step)
{
    World world = with_step(scene_of(ride), step);
    run(world, k_time);
    return world;
}

/// How far from there a run ends.  [m]
double error_of(const Ride& ride, double step)
{
    const World world = ridden(ride, step);
    const BodyState rod = world.state(0);
    return std::abs((inverse(Rotation::of(rod.angle)) * Vec2(world.state(1).position - rod.position)).x() -
                    place_of(ride));
}

Ride random_ride(Random& random, bool is_disc)
{
    Ride ride;
    ride.is_disc = is_disc;
    ride.spin = random.uniform(0.5, 2.5);
    ride.angle = random.uniform(0.0, 6.0);
    ride.start = random.uniform(-1.0, 1.0);
    ride.radius = random.uniform(0.1, 0.3);
    // Outwards, and fast enough for the rod to push all the time
    ride.slide = 0.5 + ride.spin * (k_rod + ride.radius + std::max(0.0, -ride.start)) + random.uniform(0.0, 1.0);
    if (random.below(2) == 1) {
        ride.gravity = Vec2(random.uniform(-3.0, 3.0), random.uniform(-10.0, 0.0));
        ride.velocity = Vec2(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0));
    }
    return ride;
}

} // namespace

TEST_CASE("what slides along a rod that turns freely is where the closed form says to second order of the step")
{
    Random random(31);
    for (int k = 0; k < 40; ++k) {
        Ride ride = random_ride(random, k % 2 == 0);
        if (k % 4 == 1) ride.friction = random.uniform(0.0, 0.3); // a block doesn't turn by it
        if (k % 4 == 2) ride.restitution = random.uniform(0.0, 0.9);
        CAPTURE(k);
        const double error = error_of(ride, 1.0 / 60.0);
        CHECK(error < 1e-3);
        CHECK(error_of(ride, 1.0 / 240.0) < error / 10.0 + 2e-6);
    }
}

TEST_CASE("two free bodies that slide along each other without friction keep their energy")
{
    Random random(32);
    for (int k = 0; k < 40; ++k) {
        Ride ride = random_ride(random, k % 2 == 0);
        ride.rod_mass = std::exp(random.uniform(-1.0, 3.0));
        ride.restitution = k % 4 < 2 ? 0.0 : random.uniform(0.0, 0.9);
        CAPTURE(k);
        const Report report = ridden(ride, 1.0 / 60.0).report();
        const double gained = report.energy.total() - report.initial_total;
        CHECK(gained <= 1e-12 * report.energy.kinetic);
        CHECK(gained >= -2e-5 * report.energy.kinetic);
    }
}
