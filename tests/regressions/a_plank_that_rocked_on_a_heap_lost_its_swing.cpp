// A plank rocks on a disc that lies in the gap between two boxes, on a wall or in a row of others at rest. From 13
// bodies on its ways weren't followed along curves: it sank into the disc by a little with each step, until more than
// half of its swing was taken to lift it out. The same befell a plate that hung on a knife edge.

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/effort.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

struct Rocker
{
    int rows;           // of three boxes each, below
    int beside;         // boxes on each side of the two that the disc lies on
    Vec2 box;           // width and height [m]
    double gap;         // between the two [m]
    double radius;      // of the disc [m]
    double length;      // of the plank [m]
    double thickness;   // of the plank [m]
    double spin;        // with which it begins [rad/s]
    double box_density; // [kg/m^2]
};

/// The plank is the last body.
Scene scene_of(const Rocker& r)
{
    Scene scene = on_a_floor(0.0, 0.9);
    const auto add = [&](const BodyDef& body, double density) {
        scene.bodies.push_back(body);
        scene.bodies.back().density = density;
    };
    const double width = r.box.x();
    const double height = r.box.y();
    for (int row = 0; row < r.rows; ++row) {
        for (int k = -1; k <= 1; ++k) add(rectangle(width, height, {k * width, (row + 0.5) * height}), r.box_density);
    }
    const double base = r.rows * height;
    for (int k = 0; k <= r.beside; ++k) {
        for (const double side : {-1.0, 1.0}) {
            const double x = side * (0.5 * r.gap + (k + 0.5) * width);
            add(rectangle(width, height, {x, base + 0.5 * height}), r.box_density);
        }
    }
    const double centre = base + height + std::sqrt(r.radius * r.radius - 0.25 * r.gap * r.gap);
    add(disc(r.radius, {0.0, centre}), 1.0);
    add(rectangle(r.length, r.thickness, {0.0, centre + r.radius + 0.5 * r.thickness}), 0.3);
    scene.bodies.back().spin = r.spin;
    return scene;
}

BodyDef polygon_at(std::vector<Vec2> vertices, const Vec2& position)
{
    BodyDef body;
    body.shape = PolygonDef{std::move(vertices), {}};
    body.position = position;
    return body;
}

/// A plate whose notch hangs on the edge of a wedge, on a stack of slabs. The plate is the last body.
Scene knife(int slabs, double spin)
{
    Scene scene = on_a_floor(0.0, 0.5);
    for (int k = 0; k < slabs; ++k) scene.bodies.push_back(rectangle(2.6, 0.6, {0.0, 0.6 * (k + 0.5)}));
    const double top = 0.6 * slabs;
    scene.bodies.push_back(polygon_at({{-0.5, -0.8}, {0.5, -0.8}, {0.0, 1.6}}, {0.0, top + 0.8}));
    const double below = 0.4 + 0.174 / 6.12; // its centroid, from the notch: a rectangle without a triangle [m]
    scene.bodies.push_back(
        polygon_at({{-1.8, 0.9}, {-1.8, -1.2}, {-0.9, -1.2}, {0.0, 0.4}, {0.9, -1.2}, {1.8, -1.2}, {1.8, 0.9}},
                   {0.0, top + 2.4 - below}));
    scene.bodies.back().density = 0.3;
    scene.bodies.back().spin = spin;
    scene.bodies.back().velocity = {spin * below, 0.0};
    return scene;
}

/// How fast a body turns at most in a while.  [rad/s]
double fastest(World& world, int body, double until)
{
    double top = 0.0;
    while (world.time() < until - 0.01) {
        run(world, world.time() + 1.0 / 60.0);
        top = std::max(top, std::abs(world.state(body).spin));
    }
    return top;
}

/// The swing of the last body keeps its size for some seconds, and it doesn't sink.
void check_swing(const Scene& scene)
{
    const int last = static_cast<int>(scene.bodies.size()) - 1;
    CAPTURE(last);
    World world = world_of(scene);
    const double early = fastest(world, last, 3.0);
    (void)fastest(world, last, 9.0);
    const double late = fastest(world, last, 12.0);
    CHECK(late > 0.99 * early);
    CHECK(late < 1.01 * early);
    CHECK(world.report().max_overlap < 1e-3);
}

} // namespace

TEST_CASE("a plank that rocks on a heap keeps its swing")
{
    for (const Rocker& each : tried({Rocker{4, 0, {1.158, 0.818}, 0.522, 0.424, 1.393, 0.178, 0.78, 10.0},
                                     Rocker{4, 0, {0.967, 0.984}, 0.482, 0.47, 1.641, 0.18, 1.5, 10.0},
                                     Rocker{5, 0, {0.935, 0.868}, 0.444, 0.365, 1.678, 0.119, 1.41, 10.0},
                                     Rocker{0, 8, {1.397, 0.507}, 0.59, 0.459, 2.034, 0.144, 0.81, 100.0},
                                     Rocker{0, 31, {1.388, 0.552}, 0.66, 0.568, 1.993, 0.209, 1.3, 3.0}}))
        check_swing(scene_of(each));
}

TEST_CASE("a plate on a knife edge that stands on a stack keeps its swing")
{
    for (const int slabs : tried({11, 14, 20})) check_swing(knife(slabs, 0.25));
}
