// A bracket that stood on one foot, tilted, and came down on the other one too, or a plank on its second pillar, was
// kicked in about one of twelve step lengths: all its corners closed at one moment, but those next to the point that
// bore it by the fewest digits, and these were struck alone. What should have stopped dead went on with a quarter of a
// turn per second, and what should have rocked on did so several times too fast. Boxes have one such corner only.

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/random.hpp"
#include "math/rotation.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A comb of so many teeth, one wide, with its teeth down and its centre of mass at the origin.
std::vector<Vec2> comb(int teeth, double tooth, double depth, double height)
{
    std::vector<Vec2> corners;
    Vec2 first_moment(0.0, 0.5 * height * height);
    double area = height;
    const double gap = (1.0 - teeth * tooth) / (teeth - 1);
    for (int k = 0; k < teeth; ++k) {
        const double left = -0.5 + k * (tooth + gap);
        const double right = k == teeth - 1 ? 0.5 : left + tooth;
        corners.insert(corners.end(), {Vec2(left, 0.0), Vec2(right, 0.0)});
        if (k == teeth - 1) continue;
        corners.insert(corners.end(), {Vec2(right, depth), Vec2(right + gap, depth)});
        area -= gap * depth;
        first_moment.y() -= 0.5 * gap * depth * depth;
    }
    corners.insert(corners.end(), {Vec2(0.5, height), Vec2(-0.5, height)});
    for (Vec2& corner : corners) corner -= first_moment / area;
    return corners;
}

/// A body of these corners that leans, and stands with its lowest corner on a level floor of tiles this wide.
Scene leaning(const std::vector<Vec2>& corners, double angle, double tile)
{
    Scene scene;
    scene.world.field = UniformField{Vec2(0.0, -9.81)};
    scene.world.restitution = 0.0;
    const int tiles = static_cast<int>(4.0 / tile) + 1;
    for (int k = 0; k < tiles; ++k)
        scene.bodies.push_back(still(rectangle(tile, 1.0, {(k - 0.5 * (tiles - 1)) * tile, -0.5})));
    BodyDef body;
    body.shape = PolygonDef{corners, {}};
    body.angle = angle;
    body.mass = 1.0;
    double lowest = 0.0;
    for (const Vec2& corner : corners) lowest = std::min(lowest, (Rotation::of(angle) * corner).y());
    body.position = {0.0, -lowest};
    scene.bodies.push_back(body);
    return scene;
}

/// By how much what falls flat ever lifts again, looked at in each step.  [rad]
double greatest_lift(const Scene& scene, double step, double until)
{
    World world = with_step(scene, step);
    const int body = static_cast<int>(scene.bodies.size()) - 1;
    double tilt = std::abs(scene.bodies.back().angle);
    double most = 0.0;
    for (int k = 1; k * step < until; ++k) {
        run(world, k * step);
        const double now = std::abs(world.state(body).angle);
        most = std::max(most, now - tilt);
        tilt = std::min(tilt, now);
    }
    CHECK(tilt < 1e-6); // it has come down
    return most;
}

/// How far from each other steps of several lengths lead, looked at a few times.  [rad]
double difference_of_steps(const Scene& scene, double until)
{
    constexpr int k_looks = 8;
    const int body = static_cast<int>(scene.bodies.size()) - 1;
    std::vector<double> least(k_looks, scene.bodies.back().angle + 7.0);
    std::vector<double> most(k_looks, scene.bodies.back().angle - 7.0);
    for (const int rate : {50, 60, 97, 120, 150, 240, 256, 311}) {
        World world = with_step(scene, 1.0 / rate);
        for (int k = 0; k < k_looks; ++k) {
            run(world, (k + 1) * until / k_looks);
            least[k] = std::min(least[k], world.state(body).angle);
            most[k] = std::max(most[k], world.state(body).angle);
        }
    }
    double difference = 0.0;
    for (int k = 0; k < k_looks; ++k) difference = std::max(difference, most[k] - least[k]);
    return difference;
}

/// A comb of any size that its teeth can bear: what falls flat onto it without friction stops dead, since both outer
/// corners push, a half wide each of the centre: its moment of inertia is less than a quarter of its mass.
std::vector<Vec2> any_low_comb(Random& random)
{
    const int teeth = 2 + random.below(4);
    const double depth = random.uniform(0.2, 0.4);
    return comb(teeth, random.uniform(0.3, 0.7) / teeth, depth, depth + random.uniform(0.2, 0.4));
}

} // namespace

TEST_CASE("what stands on a foot without friction and falls flat stops dead on all its feet")
{
    Random random(7);
    for (int k = 0; k < 60; ++k) {
        const std::vector<Vec2> corners = any_low_comb(random);
        const double angle = (k % 2 == 0 ? 1.0 : -1.0) * random.uniform(0.03, 0.2);
        const Scene scene = leaning(corners, angle, k % 3 == 0 ? 0.37 : 5.0);
        CAPTURE(k);
        CHECK(greatest_lift(scene, 1.0 / random.uniform(50.0, 300.0), 0.4) < 1e-5);
    }
}

TEST_CASE("a plank that comes down on its second pillar moves alike in steps of any length")
{
    Random random(8);
    for (int k = 0; k < 30; ++k) {
        Scene scene;
        scene.world.field = UniformField{Vec2(0.0, -9.81)};
        scene.world.restitution = 0.0;
        scene.world.friction = k % 3 == 0 ? 1.0 : 0.0;
        const double pillar = random.uniform(0.05, 0.25);
        for (const double side : {-0.5, 0.5}) scene.bodies.push_back(still(rectangle(pillar, 1.0, {side, -0.5})));
        const double thick = random.uniform(0.05, 0.2);
        const double angle = (k % 2 == 0 ? 1.0 : -1.0) * random.uniform(0.03, 0.2);
        // It falls onto the outer corner of one pillar
        BodyDef plank = rectangle(2.0, thick, {random.uniform(-0.1, 0.1), 0.5 * thick / std::cos(angle) + 0.001});
        plank.position.y() += (0.62 + std::abs(plank.position.x())) * std::tan(std::abs(angle));
        plank.velocity = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.0)};
        plank.angle = angle;
        scene.bodies.push_back(plank);
        CAPTURE(k);
        CHECK(difference_of_steps(scene, 0.4) < 1e-3);
    }
}

TEST_CASE("a bracket that rocks from foot to foot does so in steps of any length")
{
    // It leaves the first foot at 0.23 s, about the other one
    const std::vector<Vec2> corners = {{-0.5, -0.45}, {-0.2, -0.45}, {-0.2, -0.05}, {0.2, -0.05},
                                       {0.2, -0.45},  {0.5, -0.45},  {0.5, 0.35},   {-0.5, 0.35}};
    Scene scene = leaning(corners, -0.195, 40.0);
    scene.world.friction = 1.0;
    CHECK(difference_of_steps(scene, 0.3) < 1e-3);
    Random random(9);
    for (int k = 0; k < 12; ++k) {
        Scene other = leaning(any_low_comb(random), random.uniform(-0.2, -0.1), 40.0);
        other.world.friction = 1.0;
        other.world.restitution = k % 2 == 0 ? 0.0 : 0.5;
        CAPTURE(k);
        CHECK(difference_of_steps(other, 0.3) < 1e-3);
    }
}
