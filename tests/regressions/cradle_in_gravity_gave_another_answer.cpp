#include "support/worlds.hpp"

#include <algorithm>
#include <cmath>

#include "math/random.hpp"
#include "support/effort.hpp"

using namespace flying;
using namespace flying::testing;

// Balls in a row on a smooth floor, all but touching, answered a blow in gravity otherwise than without: what one of
// them was thrown at within a thousandth of a step was braked without rebound, and where they touched, their impacts
// came in another order than by events. A smooth floor that is level has no say in what happens along it.

namespace {

/// Approaches that are slower than a thousandth of what the field gives in a step, 1.6e-4 m/s, end without rebound, and
/// a light ball between heavy ones passes on a few times as much.  [m/s]
constexpr double k_bound = 1e-3;

struct Cradle
{
    std::vector<double> masses; ///< from left to right, the last one the striker's [kg]
    double gap = 0.0;           ///< [m]
    double restitution = 1.0;
};

/// Velocities along the floor, two seconds after the start, with a striker of 1 m/s that comes from the left.
std::vector<double> speeds(const Cradle& cradle, double gravity)
{
    Scene scene;
    if (gravity > 0.0) scene.world.field = UniformField{{0.0, -gravity}};
    scene.world.restitution = cradle.restitution;
    scene.bodies.push_back(still(rectangle(200.0, 1.0, {0.0, -0.5})));
    const int balls = static_cast<int>(cradle.masses.size()) - 1;
    for (int k = 0; k <= balls; ++k) {
        BodyDef ball = disc(0.5, {k < balls ? k * (1.0 + cradle.gap) : -1.5, 0.5});
        if (k == balls) ball.velocity = Vec2(1.0, 0.0);
        ball.mass = cradle.masses[k];
        scene.bodies.push_back(ball);
    }
    World world = world_of(scene);
    run(world, 2.0);
    std::vector<double> all;
    for (int k = 1; k < world.body_count(); ++k) all.push_back(world.state(k).velocity.x());
    return all;
}

double difference(const Cradle& cradle)
{
    const std::vector<double> with = speeds(cradle, 9.81);
    const std::vector<double> without = speeds(cradle, 0.0);
    double worst = 0.0;
    for (std::size_t k = 0; k < with.size(); ++k) worst = std::max(worst, std::abs(with[k] - without[k]));
    return worst;
}

std::vector<double> masses_of(int balls, bool are_wide, Random& random)
{
    std::vector<double> masses;
    const double wide[] = {0.3, 1.0, 3.0, 10.0};
    for (int k = 0; k <= balls; ++k) masses.push_back(are_wide ? wide[random.below(4)] : random.uniform(0.5, 2.0));
    return masses;
}

} // namespace

TEST_CASE("a cradle of unequal balls answers in gravity as it does without, however small its gaps")
{
    Random random(1);
    for (int balls = 3; balls <= 7; ++balls) {
        for (const double gap : {1e-3, 1e-4, 1e-6, 1e-9, 0.0}) {
            for (const double restitution : {1.0, 0.9}) {
                for (const bool are_wide : {false, true}) {
                    const Cradle cradle{masses_of(balls, are_wide, random), gap, restitution};
                    CAPTURE(balls);
                    CAPTURE(gap);
                    CAPTURE(restitution);
                    CHECK(difference(cradle) < k_bound);
                }
            }
        }
    }
}

TEST_CASE("where its bounces die away, it comes to the same but for how slow they are then")
{
    Random random(2);
    for (int balls = 3; balls <= 7; ++balls) {
        for (const double gap : {1e-3, 1e-4, 1e-6, 1e-9, 0.0}) {
            for (const bool are_wide : {false, true}) {
                const Cradle cradle{masses_of(balls, are_wide, random), gap, 0.5};
                CAPTURE(balls);
                CAPTURE(gap);
                CHECK(difference(cradle) < k_bound);
            }
        }
    }
}

// A row of 64 balls and more had all impacts of a step at its start, and one of unequal balls more impacts in a step
// than it may have parts
TEST_CASE("a long row of balls, or of unequal ones, answers in gravity as it does without")
{
    Random random(2);
    for (const double gap : tried({1e-4, 1e-6, 1e-8})) {
        CAPTURE(gap);
        for (const int balls : {66, 90}) {
            const std::vector<double> masses(static_cast<std::size_t>(balls) + 1, 1.5);
            CHECK(difference({masses, gap, 1.0}) < 1e-12);
        }
        for (const int balls : {24, 45, 66}) CHECK(difference({masses_of(balls, false, random), gap, 1.0}) < 1e-12);
    }
}

// Blows to what is pressed together never end, so such a row isn't followed through all of them
TEST_CASE("balls that lean on each other in a trough, and lose nothing, aren't followed from impact to impact")
{
    Random random(2);
    const double tilt = 0.1;
    Scene scene;
    scene.world.field = UniformField{{9.81 * std::sin(tilt), -9.81 * std::cos(tilt)}};
    scene.world.restitution = 1.0;
    scene.bodies.push_back(still(rectangle(900.0, 1.0, {0.0, -0.5})));
    constexpr int balls = 120;
    scene.bodies.push_back(still(rectangle(1.0, 4.0, {0.5 * balls + 0.5, 2.0})));
    for (int k = 0; k < balls; ++k) {
        scene.bodies.push_back(disc(0.25, {0.25 + 0.5 * k, 0.25}));
        scene.bodies.back().mass = random.uniform(0.5, 2.0);
    }
    scene.bodies.push_back(disc(0.25, {-1.5, 0.25}));
    scene.bodies.back().velocity = Vec2(3.0, 0.0);
    World world = world_of(scene);
    run(world, 0.5);
    const Report report = world.report();
    REQUIRE(report.rest);
    CHECK(report.rest->parts < 200); // without that rule, tens of thousands
}
