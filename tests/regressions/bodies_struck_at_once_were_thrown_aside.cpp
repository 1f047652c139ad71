// A disc that met two others at one moment was thrown aside: their impacts came one after the other, the body's of the
// lower number first. So a rack of balls, struck in the middle, opened to one side, and with its bodies listed the
// other way round, to the other.

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/bodies.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

struct Rack
{
    int rows = 3;
    double restitution = 1.0;
    double friction = 0.0;
    double striker = 1.0; ///< its mass, to that of the others
};

/// Balls in a triangle whose point is struck, mirrored about x = 0.
Scene scene_of(const Rack& rack, bool is_reversed)
{
    Scene scene;
    scene.world.restitution = rack.restitution;
    scene.world.friction = rack.friction;
    std::vector<BodyDef> balls;
    const double root = std::sqrt(0.75);
    for (int row = 0; row < rack.rows; ++row) {
        for (int k = 0; k <= row; ++k) balls.push_back(disc(0.5, {k - 0.5 * row, -root * row}));
    }
    if (is_reversed) std::reverse(balls.begin(), balls.end());
    BodyDef striker = disc(0.5, {0.0, 3.0}, {0.0, -4.0});
    striker.mass = rack.striker;
    for (BodyDef& ball : balls) ball.mass = 1.0;
    scene.bodies = balls;
    scene.bodies.push_back(striker);
    return scene;
}

/// The farthest that a ball is from the mirrored place of another.
double lopsidedness(const World& world)
{
    double worst = 0.0;
    for (int k = 0; k < world.body_count(); ++k) {
        const Vec2 place = world.state(k).position;
        double nearest = 1e9;
        for (int other = 0; other < world.body_count(); ++other)
            nearest = std::min(nearest, (world.state(other).position - Vec2(-place.x(), place.y())).norm());
        worst = std::max(worst, nearest);
    }
    return worst;
}

} // namespace

TEST_CASE("a rack of balls that is struck in the middle opens alike to both sides, whoever is listed first")
{
    for (const int rows : {2, 3, 4, 5}) {
        for (const double restitution : {1.0, 0.9, 0.5}) {
            for (const double friction : {0.0, 0.3}) {
                for (const double striker : {1.0, 3.0}) {
                    for (const bool is_reversed : {false, true}) {
                        const Rack rack{rows, restitution, friction, striker};
                        CAPTURE(rows);
                        CAPTURE(restitution);
                        CAPTURE(friction);
                        World world = world_of(scene_of(rack, is_reversed));
                        run(world, 2.0);
                        CHECK(lopsidedness(world) < 1e-9);
                    }
                }
            }
        }
    }
}

TEST_CASE("a ball that falls on two beside each other on a floor parts them alike")
{
    for (const double restitution : {0.0, 0.5, 0.9, 1.0}) {
        for (const double friction : {0.0, 0.2, 0.8}) {
            for (const double height : {1.0, 2.0, 3.3}) {
                Scene scene;
                scene.world.field = UniformField{{0.0, -9.81}};
                scene.world.restitution = restitution;
                scene.world.friction = friction;
                scene.bodies = {still(rectangle(40.0, 1.0, {0.0, -0.5})), disc(0.5, {0.5, 0.5}), disc(0.5, {-0.5, 0.5}),
                                disc(0.7, {0.0, 1.0 + height})};
                World world = world_of(scene);
                run(world, 0.6);
                CAPTURE(restitution);
                CAPTURE(friction);
                CAPTURE(height);
                CHECK(std::abs(world.state(3).position.x()) < 1e-9);
                CHECK(std::abs(world.state(1).position.x() + world.state(2).position.x()) < 1e-9);
            }
        }
    }
}
