// A slim book dropped between others and a wall took up to thirty seconds of computing for the step in which it
// landed. Books that stand side by side have one joint foot. A book two places away touched that foot with a corner of
// its own, since the contact between them was to be one along the joint surface's normal: it was held up and down at
// once, over a book that stood between, and blows at the rounding of speeds never ended.

#include <algorithm>
#include <cmath>
#include <string>

#include "math/random.hpp"
#include "support/effort.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Books of height 1 that stand side by side along a wall whose face is at x = 0; the place next to it is free, and one
/// book is over it.
///
/// slit  between a book and the next, or the wall [m]
Scene shelf(int count, double width, double slit, double height, const Material& material)
{
    Scene scene;
    scene.world.field = UniformField{{0.0, -9.81}};
    scene.world.restitution = material.restitution;
    scene.world.friction = material.friction;
    scene.world.box = BoxDef{{-3.0, 0.0}, {3.0, 5.0}};
    scene.bodies = {still(rectangle(0.2, 5.0, {0.1, 2.5}))};
    const auto place = [&](int k) { return -(0.5 * width + slit) - k * (width + slit); };
    scene.bodies.push_back(rectangle(width, 1.0, {place(0), 0.5 + height}));
    for (int k = 1; k <= count; ++k) scene.bodies.push_back(rectangle(width, 1.0, {place(k), 0.5}));
    return scene;
}

} // namespace

TEST_CASE("a book that is put back beside others lands and stands, however slim")
{
    for (const int count : {2, 3, 5}) {
        for (const double width : {0.001, 0.005, 0.02, 0.1}) {
            for (const double slit : {0.0, 1e-12, 1e-9}) {
                for (const Material& material : {Material{0.2, 0.0}, Material{0.5, 0.3}, Material{0.1, 0.05}}) {
                    CAPTURE(count);
                    CAPTURE(width);
                    CAPTURE(slit);
                    CAPTURE(material.restitution);
                    World world = world_of(shelf(count, width, slit, 0.6, material));
                    run(world, 1.5);
                    CHECK(world.report().collisions <= 5000);
                    for (int k = 1; k < world.body_count(); ++k)
                        CHECK(std::abs(world.state(k).position.y() - 0.5) <= 1e-3);
                }
            }
        }
    }
}

TEST_CASE("slim rods that are thrown at a wall stay on their side of it")
{
    // What counted as near was longer than a rod is thick: what lay on a rod on the floor was taken to touch the wall's
    // foot
    const int scenes = tried(4);
    for (const double width : {1e-4, 1e-3, 1e-2}) {
        for (int seed = 1; seed <= scenes; ++seed) {
            CAPTURE(width);
            CAPTURE(seed);
            Random random(static_cast<std::uint64_t>(7040 + seed));
            Scene scene;
            scene.world.field = UniformField{{0.0, -9.81}};
            scene.world.restitution = 0.0;
            scene.world.friction = 0.0;
            scene.world.box = BoxDef{{-9.0, 0.0}, {9.0, 12.0}};
            scene.bodies = {still(rectangle(0.02, 12.0, {0.0, 6.0}))};
            for (int k = 0; k < 12; ++k) {
                const double speed = random.uniform(14.0, 20.0);
                const double rise = random.uniform(-0.4, 0.4);
                BodyDef rod = rectangle(1.0, width, {-7.0 + 1.2 * (k % 5), 1.0 + 1.2 * (k / 5)},
                                        speed * Vec2(std::cos(rise), std::sin(rise)));
                rod.angle = random.uniform(0.0, 3.0);
                rod.spin = random.uniform(-6.0, 6.0);
                scene.bodies.push_back(rod);
            }
            World world = world_of(scene);
            for (int k = 1; k <= 90; ++k) {
                run(world, k / 60.0);
                CHECK(deepest_overlap(world) <= 0.01);
            }
            for (int k = 1; k < world.body_count(); ++k) CHECK(world.state(k).position.x() < 0.0);
        }
    }
}
