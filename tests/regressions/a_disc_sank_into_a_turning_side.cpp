// A side that turns after a disc catches it again and again: hops without end in no time. Each may come late by a
// rounding, and by some hundreds of them the disc lay so far behind the side that the search for impacts took it for one
// that lies beyond its ends: it went through. Two polygons that creep so into each other were given to the resting
// integrator in time, a disc and a polygon were not.

#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A small disc that spins, and meets a side of a larger square that turns, each time with less speed.
Scene disc_at_square(double restitution, double friction, double spin)
{
    Scene scene;
    scene.world.restitution = restitution;
    scene.world.friction = friction;
    scene.bodies.push_back(rectangle(1.363288, 1.363288, {-1.9905826081977993, 6.4773585728521372},
                                     {-0.24941497885239226, 1.7505066018635659}));
    scene.bodies.back().angle = 18.53576462793831;
    scene.bodies.back().spin = -1.2998781924891392;
    scene.bodies.push_back(disc(6.41831e-3, {-2.0392285340812702, 5.7695236384483761}, {1.7413105339753308, 0.82356924342793127}));
    scene.bodies.back().spin = spin;
    return scene;
}

} // namespace

TEST_CASE("a disc that a turning side catches ever again stays in front of it")
{
    for (const double restitution : {0.0, 0.2, 0.4, 0.5, 0.6, 0.603709, 0.62, 0.65, 0.7}) {
        for (const double friction : {0.0, 0.3, 0.700975}) {
            for (const double spin : {0.0, 100.0, 477.4290854323894}) {
                CAPTURE(restitution);
                CAPTURE(friction);
                CAPTURE(spin);
                World world = world_of(disc_at_square(restitution, friction, spin));
                for (int k = 1; k <= 30; ++k) {
                    run(world, 0.004 * k);
                    (void)world.report(); // looks at what overlaps
                }
                CHECK(world.report().collisions > 0);
                CHECK(world.report().max_overlap < 1e-3 * 6.41831e-3);
            }
        }
    }
}
