#include "support/worlds.hpp"

#include <algorithm>
#include <cmath>

#include "math/rotation.hpp"

using namespace flying;
using namespace flying::testing;

// A corner at the bottom of a notch touches both flanks. Where the friction cones of the flanks meet, it was taken for a
// point on a corner, along whatever direction rounding gave their distance: a plate that hung on a knife edge lost up to all
// of its swing in one step, and a rod that fell over about its tip stopped in the air.

namespace {

constexpr double k_gravity = 9.81;

BodyDef polygon_at(const std::vector<Vec2>& vertices, const Vec2& position, double angle = 0.0)
{
    BodyDef body;
    body.shape = PolygonDef{vertices, {}};
    body.position = position;
    body.angle = angle;
    return body;
}

Vec2 centroid_of(const std::vector<Vec2>& v)
{
    double area = 0.0;
    Vec2 sum = Vec2::Zero();
    for (std::size_t k = 0; k < v.size(); ++k) {
        const double part = cross(v[k], v[(k + 1) % v.size()]);
        area += part / 2.0;
        sum += (v[k] + v[(k + 1) % v.size()]) * (part / 6.0);
    }
    return sum / area;
}

Scene scene_of(double mu)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -k_gravity}};
    scene.world.restitution = 0.0;
    scene.world.friction = mu;
    return scene;
}

/// A plate whose notch, open below, hangs on the edge of a wedge; turned by an angle about that edge.
struct Knife
{
    Scene scene;
    double arm = 0.0; ///< from the edge to the centroid [m]
};

Knife knife(double mu, double amplitude, double half_width, double turned)
{
    // The notch is 2 m deep, and wider than the wedge by far
    const std::vector<Vec2> plate = {{-2.0, 0.5},         {-2.0, -2.0}, {-half_width, -2.0}, {0.0, 0.0},
                                     {half_width, -2.0}, {2.0, -2.0},  {2.0, 0.5}};
    const std::vector<Vec2> wedge = {{0.0, 0.0}, {-0.15, -2.5}, {0.15, -2.5}};
    Knife result;
    result.scene = scene_of(mu);
    const Vec2 centroid = centroid_of(plate);
    result.arm = centroid.norm();
    result.scene.bodies.push_back(polygon_at(plate, Rotation::of(amplitude) * centroid, amplitude));
    const Rotation lean = Rotation::of(turned);
    result.scene.bodies.push_back(still(polygon_at(wedge, lean * centroid_of(wedge), turned)));
    return result;
}

} // namespace

TEST_CASE("a plate on a knife edge keeps its swing, whatever the friction")
{
    for (const double mu : {0.2, 0.45, 0.49, 0.51, 0.6, 0.8, 1.0, 2.0, 10.0}) {
        double least = 1.0;
        for (const double half_width : {0.8, 1.0, 1.3}) {
            for (const double amplitude : {0.021, 0.0323, 0.09, 0.17}) {
                const Knife k = knife(mu, amplitude, half_width, half_width == 1.3 ? 0.02 : 0.0);
                World world = world_of(k.scene);
                const Report before = world.report();
                const double lowest = -before.bodies[0].mass * k_gravity * k.arm;
                run(world, 5.0);
                least = std::min(least, (world.report().energy.total() - lowest) / (before.energy.total() - lowest));
            }
        }
        INFO("friction " << mu << ", least share kept " << least);
        CHECK(least >= 0.99);
    }
}

TEST_CASE("a rod falls over about its tip in a notch")
{
    for (const double mu : {0.3, 0.6, 1.0, 3.0}) {
        for (const double half_angle : {0.9, 1.1, 1.3}) {
            for (const double lean : {0.05, -0.1, 0.2}) {
                const double width = 0.5 * std::tan(half_angle);
                const std::vector<Vec2> rod = {{0.0, 0.0}, {0.05, 0.1}, {0.05, 2.0}, {-0.05, 2.0}, {-0.05, 0.1}};
                const std::vector<Vec2> block = {{-3.0, 0.5}, {-3.0, -1.0}, {3.0, -1.0}, {3.0, 0.5},
                                                 {width, 0.5}, {0.0, 0.0},   {-width, 0.5}};
                Scene scene = scene_of(mu);
                scene.bodies.push_back(polygon_at(rod, Rotation::of(lean) * centroid_of(rod), lean));
                scene.bodies.push_back(still(polygon_at(block, centroid_of(block))));
                World world = world_of(scene);
                const double start = world.report().energy.total();
                const double until = half_angle - 0.52; // the rod's tip is as wide as 0.46 rad on either side
                double worst = 0.0;
                double spin = 0.0;
                for (int step = 1; step < 240 && std::abs(world.state(0).angle) < until; ++step) {
                    run(world, step / 60.0);
                    const Report now = world.report();
                    if (now.energy.kinetic > 1e-3) worst = std::max(worst, std::abs(now.energy.total() - start) / now.energy.kinetic);
                    spin = world.state(0).spin;
                }
                INFO("friction " << mu << ", half angle " << half_angle << ", lean " << lean << ", worst " << worst);
                CHECK(worst <= 0.02);
                CHECK(spin * lean > 0.0);
                CHECK(std::abs(world.state(0).angle) >= until);
            }
        }
    }
}
