// Fourteen boxes side by side, or a low wall, on a slope that is too steep by a hundredth: some slid as one box does,
// and some stood for ever, as the third digit of their friction had it. All start to slide at once and bear nothing on
// each other, which left the search for their forces at a corner of its path; sweeps then took what they lacked for
// rest.

#include <cmath>

#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

constexpr double k_weight = 9.81; // [m/s^2]

/// Bricks of .5 m by .25 m in layers, each half a brick beside the one below.
struct SlopingWall
{
    int layers;
    int columns;
};

/// On a slope through the origin.
Scene wall_on_slope(const SlopingWall& wall, double slope, double friction)
{
    const Rotation turned = Rotation::of(slope);
    Scene scene = on_a_floor(0.0, friction);
    scene.bodies[0] = still(rectangle(200.0, 1.0, turned * Vec2(0.0, -0.5)));
    scene.bodies[0].angle = slope;
    for (int layer = 0; layer < wall.layers; ++layer) {
        for (int column = 0; column < wall.columns - layer % 2; ++column) {
            const Vec2 place{0.5 * column + 0.25 * (layer % 2), 0.25 * layer + 0.125};
            scene.bodies.push_back(rectangle(0.5, 0.25, turned * place));
            scene.bodies.back().angle = slope;
        }
    }
    return scene;
}

} // namespace

TEST_CASE("boxes and walls of up to 64 begin to slide on any slope that is too steep and go as far as one would")
{
    for (const SlopingWall& wall :
         {SlopingWall{1, 14}, SlopingWall{1, 23}, SlopingWall{1, 37}, SlopingWall{2, 8}, SlopingWall{4, 6}}) {
        for (const double slope : {0.1, 0.23, 0.4}) {
            for (const double lacks : {0.0005, 0.002, 0.01, 0.02}) {
                CAPTURE(wall.layers);
                CAPTURE(wall.columns);
                CAPTURE(slope);
                CAPTURE(lacks);
                const Scene scene = wall_on_slope(wall, slope, (1.0 - lacks) * std::tan(slope));
                World world = world_of(scene);
                run(world, 0.5);
                const double way = 0.5 * lacks * k_weight * std::sin(slope) * 0.5 * 0.5;
                for (int k = 1; k < world.body_count(); ++k) {
                    const Vec2 went = world.state(k).position - scene.bodies[k].position;
                    CHECK(went.norm() == doctest::Approx(way).epsilon(1e-3));
                }
            }
        }
    }
}
