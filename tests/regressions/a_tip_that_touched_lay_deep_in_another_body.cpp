// Two bodies that slid along one floor and met tip to tip got into each other by the height of a body: rounding had put
// the tip of one into the other, and the nearest side that it faced, and so was to leave over, was that body's far side.

#include <algorithm>

#include "collide/separation.hpp"
#include "geometry/make_polygon.hpp"
#include "rest/outline_points.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("of two tips that meet along a line, neither lies deep in the other because rounding puts it there")
{
    // Two that slide along a floor, each on its tip; the one's side hangs over the other's tip
    const Polygon hull({{Vec2(-2.0, 0.0), Vec2(0.0, 0.0), Vec2(1.5, 2.9), Vec2(1.0, 5.0), Vec2(-2.0, 5.0)}});
    const Polygon wedge({{Vec2(0.0, 0.0), Vec2(0.95, 0.045), Vec2(0.7, 0.8)}});
    const Outline outline_a(hull, make_collision_shape(hull));
    const Outline outline_b(wedge, make_collision_shape(wedge));
    for (const double angle : {0.0, 0.7, 2.0}) {
        const Rotation turn = Rotation::of(angle);
        const Pose pose_a{Vec2(0.3, -0.2), turn};
        for (const double depth : {1e-9, 3e-6, 1e-3}) {
            for (const double height : {0.0, 1e-13, -1e-13}) {
                CAPTURE(angle);
                CAPTURE(depth);
                CAPTURE(height);
                const Pose pose_b{pose_a.position + turn * Vec2(-depth, height), turn};
                const Manifold manifold = outline_points({outline_a, 0, pose_a}, {outline_b, 0, pose_b}, 0.01, 1e-12);
                for (int k = 0; k < manifold.count; ++k) CHECK(manifold.contacts[k].separation > -1.01 * depth);
            }
        }
    }
}

TEST_CASE("what slides along a floor into a tip drives it on, and gets no deeper into it than rounding")
{
    for (const double mass : {1e3, 1e6}) {
        for (const double speed : {5.0, 40.0}) {
            CAPTURE(mass);
            CAPTURE(speed);
            const auto body = [&](std::vector<Vec2> vertices, double x, double v) {
                BodyDef def;
                def.position = make_polygon({vertices}).value().centroid + Vec2(x, 0.0);
                def.shape = PolygonDef{std::move(vertices), {}};
                def.velocity = Vec2(v, 0.0);
                return def;
            };
            Scene scene;
            scene.world.field = UniformField{{0.0, -10.0}};
            scene.world.restitution = 0.0;
            scene.world.friction = 0.0;
            scene.world.box = BoxDef{{-20.0, 0.0}, {20.0, 20.0}};
            // A heavy hull, whose side hangs over the tip of a star in front of it
            scene.bodies = {body({{-2.0, 0.0}, {0.0, 0.0}, {1.5, 2.9}, {1.0, 5.0}, {-2.0, 5.0}}, -10.0, speed),
                            body({{0.0, 0.0}, {0.95, 0.045}, {1.6, 0.0}, {1.0, 0.5}, {0.7, 0.8}}, 0.0, 0.0)};
            scene.bodies[0].mass = mass;
            scene.bodies[1].mass = 1.0;
            World world = world_of(scene);
            double worst = 0.0;
            while (world.time() < 5.0) {
                run(world, world.time() + 1.0 / 60.0);
                worst = std::max(worst, deepest_overlap(world));
            }
            CHECK(worst < 0.002);
        }
    }
}
