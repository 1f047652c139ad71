// Rows of more than 64 bodies moved by the velocity with which each step ended: on a slope of ice they were ahead by
// 0.7 % after two seconds, and had lost as much of their energy; rows that friction stopped stopped 2 to 4 % short. Of
// 64 the same row was right to rounding.

#include <algorithm>
#include <cmath>

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

constexpr double k_pull = 9.81; // [m/s^2]

/// Bodies side by side on a floor that slopes.
///
/// slope    [rad]
/// spacing  of their centres [m]
Scene row(int count, const BodyDef& body, double spacing, double slope, double friction)
{
    Scene scene;
    scene.world.field = UniformField{{k_pull * std::sin(slope), -k_pull * std::cos(slope)}};
    scene.world.restitution = 0.0;
    scene.world.friction = friction;
    scene.bodies.push_back(still(rectangle(2000.0, 1.0, {0.0, -0.5})));
    for (int k = 0; k < count; ++k) {
        scene.bodies.push_back(body);
        scene.bodies.back().position.x() = k * spacing;
    }
    return scene;
}

struct Slid
{
    double least = 0.0; ///< of all bodies [m]
    double most = 0.0;  ///< [m]
};

Slid slid(const World& world, const Scene& scene)
{
    Slid ways{1e9, -1e9};
    for (int k = 1; k < world.body_count(); ++k) {
        const double way = world.state(k).position.x() - scene.bodies[k].position.x();
        ways = {std::min(ways.least, way), std::max(ways.most, way)};
    }
    return ways;
}

} // namespace

TEST_CASE("rows of boxes slide down ice, and discs roll down a slope, as far as one would, whatever their number")
{
    for (const int count : {64, 65, 90, 200}) {
        for (const double slope : {0.02, 0.3, 0.9}) {
            CAPTURE(count);
            CAPTURE(slope);
            constexpr double k_until = 1.5; // [s]
            const double fall = 0.5 * k_pull * std::sin(slope) * k_until * k_until;

            const Scene boxes = row(count, rectangle(0.5, 0.3, {0.0, 0.15}), 0.5, slope, 0.0);
            World on_ice = world_of(boxes);
            run(on_ice, k_until);
            CHECK(slid(on_ice, boxes).least >= (1.0 - 1e-11) * fall);
            CHECK(slid(on_ice, boxes).most <= (1.0 + 1e-11) * fall);
            const Report report = on_ice.report();
            const double gained = report.energy.total() - report.initial_total;
            CHECK(gained <= 1e-12 * report.energy.kinetic);
            CHECK(gained >= -1e-7 * report.energy.kinetic); // what sweeps leave

            const Scene discs = row(count, disc(0.25, {0.0, 0.25}), 0.51, slope, 1.0);
            World on_rock = world_of(discs);
            run(on_rock, k_until);
            CHECK(slid(on_rock, discs).least >= (1.0 - 1e-9) * fall / 1.5);
            CHECK(slid(on_rock, discs).most <= (1.0 + 1e-9) * fall / 1.5);
        }
    }
}

TEST_CASE("a row of boxes that friction stops comes as far as one box")
{
    for (const int count : {65, 90, 150}) {
        for (const double friction : {0.12, 0.3, 0.6}) {
            for (const double speed : {1.0, 2.3}) {
                CAPTURE(count);
                CAPTURE(friction);
                CAPTURE(speed);
                Scene scene = row(count, rectangle(0.6, 0.3, {0.0, 0.15}, {speed, 0.0}), 0.6, 0.0, friction);
                World world = world_of(scene);
                run(world, 0.2 + speed / (friction * k_pull));
                const double way = speed * speed / (2.0 * friction * k_pull);
                const double within_a_step =
                    0.125 * friction * k_pull / 3600.0; // the sagitta of a step in which it stops
                CHECK(slid(world, scene).least >= way - within_a_step);
                CHECK(slid(world, scene).most <= way + within_a_step);
            }
        }
    }
}
