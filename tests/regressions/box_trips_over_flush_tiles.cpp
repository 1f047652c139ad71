#include "support/worlds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/aabb.hpp"
#include "math/random.hpp"
#include "math/rotation.hpp"

using namespace flying;
using namespace flying::testing;

// A floor of tiles laid side by side, tops level to rounding, was full of invisible steps: a box that slid over it tripped
// at every second seam, and a disc lost speed. Expected values are those of the same motion over one slab.

namespace {

enum class Laid { squares, rectangles, polygons };

struct Floor
{
    double tile = 1.0; ///< [m]
    double slope = 0.0;
    Laid laid = Laid::rectangles;
};

constexpr double k_begin = -2.0; // where the first tile begins [m]
constexpr double k_length = 40.0;

BodyDef tile_at(const Floor& floor, int k)
{
    const Rotation turned = Rotation::of(floor.slope);
    const double height = floor.laid == Laid::squares ? floor.tile : 0.3;
    BodyDef body;
    if (floor.laid == Laid::squares) body.shape = SquareDef{floor.tile};
    else if (floor.laid == Laid::rectangles) body.shape = RectangleDef{floor.tile, height};
    // Its centroid is off the origin, and rounded
    else body.shape = PolygonDef{{Vec2(0.1, 0.2), Vec2(0.1 + floor.tile, 0.2), Vec2(0.1 + floor.tile, 0.2 + height),
                                  Vec2(0.1, 0.2 + height)}, {}};
    body.position = turned * Vec2(k_begin + (k + 0.5) * floor.tile, -0.5 * height);
    body.angle = floor.slope;
    return still(body);
}

/// One body on such a floor, or on one slab.
Scene on_floor(const Floor& floor, bool is_slab, const BodyDef& body, double e, double mu, Field field)
{
    Scene scene;
    scene.world.field = field;
    scene.world.restitution = e;
    scene.world.friction = mu;
    if (is_slab) {
        Floor slab = floor;
        slab.tile = k_length;
        slab.laid = Laid::rectangles;
        scene.bodies.push_back(tile_at(slab, 0));
    } else {
        for (int k = 0; k < static_cast<int>(k_length / floor.tile); ++k) scene.bodies.push_back(tile_at(floor, k));
    }
    scene.bodies.push_back(body);
    return scene;
}

/// A box, a polygon with as many sides, or a disc, that lies on the floor's plane and slides up or down along it.
BodyDef slider(int sides, double size, const Floor& floor, double x, double v)
{
    const Rotation turned = Rotation::of(floor.slope);
    BodyDef body;
    double height = size;
    body.angle = floor.slope;
    if (sides == 0) body.shape = DiscDef{size};
    else if (sides == 4) {
        body.shape = RectangleDef{2.0 * size, size};
        height = 0.5 * size;
    } else {
        body.shape = RegularDef{sides, size};
        height = size * std::cos(std::numbers::pi / sides);
        body.angle -= std::numbers::pi / 2.0 + std::numbers::pi / sides;
    }
    body.position = turned * Vec2(x, height);
    body.velocity = turned * Vec2(v, 0.0);
    return body;
}

double difference(const BodyState& one, const BodyState& two)
{
    return std::max({(one.position - two.position).norm(), (one.velocity - two.velocity).norm(),
                     std::abs(one.angle - two.angle), std::abs(one.spin - two.spin)});
}

/// The least height of a body.  [m]
double lowest(const BodyDef& body)
{
    Scene alone;
    alone.bodies = {body};
    const World world = world_of(alone);
    return bounding_box(world.shape(0), {world.state(0).position, Rotation::of(world.state(0).angle)}).min.y();
}

BodyState end_of(const Scene& scene, EngineChoice engine, double until)
{
    World world = world_of(scene, engine);
    run(world, until);
    return world.state(static_cast<int>(scene.bodies.size()) - 1);
}

const Field k_field = UniformField{Vec2(0.0, -9.81)};

} // namespace

TEST_CASE("what slides over flush tiles slides as on one slab")
{
    constexpr double k_bound = 1e-9; // of metres, radians and their rates: rounding, over up to 160 seams
    Random random(20);
    for (int k = 0; k < 60; ++k) {
        const double tiles[] = {0.25, 1.0 / 3.0, 0.37, 0.5, 1.0, 2.0};
        const int shapes[] = {4, 4, 5, 6, 8};
        const double speeds[] = {0.5, 2.0, 5.0, 9.78, 15.0};
        const double e[] = {0.0, 0.3, 0.5, 0.9, 1.0};
        Floor floor;
        floor.tile = tiles[random.below(6)];
        floor.laid = static_cast<Laid>(random.below(3));
        floor.slope = k % 3 == 0 ? random.uniform(-0.3, 0.3) : 0.0;
        const int sides = shapes[random.below(5)];
        const double mu = k % 2 == 0 ? 0.0 : random.uniform(0.1, sides == 4 ? 0.9 : 0.3);
        const BodyDef body = slider(sides, random.uniform(0.2, 0.7), floor, k % 4 == 0 ? 0.0 : random.uniform(0.0, 2.0),
                                    speeds[random.below(5)]);
        const double restitution = e[random.below(5)];
        CAPTURE(k);
        CAPTURE(floor.tile);
        for (const EngineChoice engine : {EngineChoice::automatic, EngineChoice::rest}) {
            if (engine == EngineChoice::rest && k % 6 != 0) continue;
            const BodyState over_tiles = end_of(on_floor(floor, false, body, restitution, mu, k_field), engine, 1.5);
            const BodyState over_slab = end_of(on_floor(floor, true, body, restitution, mu, k_field), engine, 1.5);
            CHECK(difference(over_tiles, over_slab) < k_bound);
        }
    }
}

TEST_CASE("what glides over flush tiles without a field meets nothing, by exact events")
{
    Random random(21);
    for (int k = 0; k < 24; ++k) {
        const double tiles[] = {0.25, 1.0 / 3.0, 0.37, 0.5, 1.0};
        const int shapes[] = {0, 4, 6, 8};
        Floor floor;
        floor.tile = tiles[k % 5];
        floor.laid = static_cast<Laid>(k % 3);
        floor.slope = k % 2 == 0 ? 0.0 : random.uniform(-0.3, 0.3);
        const double v = random.uniform(0.5, 15.0);
        const BodyDef body = slider(shapes[k % 4], 0.3, floor, 0.0, v);
        const BodyState end = end_of(on_floor(floor, false, body, 0.5 * (k % 3), 0.5 * (k % 2), NoField{}), EngineChoice::events, 1.0);
        CAPTURE(k);
        CHECK((end.position - (body.position + body.velocity)).norm() < 1e-12 * v);
        CHECK((end.velocity - body.velocity).norm() < 1e-12 * v);
    }
}

TEST_CASE("a concave body that slides over flush tiles slides as on one slab")
{
    // Where a corner of its had passed one of a tile's by next to nothing, it fell through both tiles
    const std::vector<std::vector<Vec2>> shapes = {
        {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.25}, {0.25, 0.25}, {0.25, 1.0}, {0.0, 1.0}},
        {{-0.5, 0.0}, {0.5, 0.0}, {0.5, 0.25}, {0.125, 0.25}, {0.125, 0.75}, {-0.125, 0.75}, {-0.125, 0.25}, {-0.5, 0.25}},
        {{0.0, 0.0}, {0.25, 0.0}, {0.25, 0.5}, {0.75, 0.5}, {0.75, 0.0}, {1.0, 0.0}, {1.0, 0.75}, {0.0, 0.75}}};
    Random random(23);
    for (int k = 0; k < 30; ++k) {
        Floor floor;
        floor.tile = k % 3 == 0 ? 0.5 : random.uniform(0.15, 0.9);
        const double size = random.uniform(0.5, 1.0);
        const double restitution = 0.5 * random.below(3);
        const double mu = k % 2 == 0 ? 0.0 : 0.3;
        BodyDef body;
        PolygonDef shape;
        for (const Vec2& vertex : shapes[k % 3]) shape.vertices.push_back(size * vertex);
        body.shape = shape;
        body.position = {0.1, 0.0};
        body.velocity = {random.uniform(1.0, 6.0), 0.0};
        body.position.y() -= lowest(body); // the position is the centroid's
        const Scene scene = on_floor(floor, false, body, restitution, mu, k_field);
        const Scene slab = on_floor(floor, true, body, restitution, mu, k_field);
        CAPTURE(k);
        for (const EngineChoice engine : {EngineChoice::automatic, EngineChoice::rest})
            CHECK(difference(end_of(scene, engine, 1.2), end_of(slab, engine, 1.2)) < 1e-9);
    }
}

TEST_CASE("a box that falls flat on tiles is thrown back flat")
{
    Random random(22);
    for (int k = 0; k < 24; ++k) {
        Floor floor;
        floor.tile = k % 2 == 0 ? 0.37 : 0.25;
        BodyDef body = slider(4, 0.35, floor, random.uniform(0.0, 1.0), k % 3 == 0 ? 0.0 : 2.0);
        body.position.y() += 0.6;
        const double mu[] = {0.0, 0.5, 0.2, 1.0};
        const double restitution = k % 3 == 1 ? 1.0 : 0.8;
        CAPTURE(k);
        for (const EngineChoice engine : {EngineChoice::automatic, EngineChoice::rest}) {
            const BodyState end = end_of(on_floor(floor, false, body, restitution, mu[k % 4], k_field), engine, 0.9);
            const BodyState slab = end_of(on_floor(floor, true, body, restitution, mu[k % 4], k_field), engine, 0.9);
            CHECK(difference(end, slab) < 1e-9);
        }
    }
}

TEST_CASE("a disc that rolls over flush tiles keeps its speed")
{
    for (const double e : {0.0, 0.5, 1.0}) {
        for (const double tile : {0.25, 0.37, 1.0}) {
            Floor floor;
            floor.tile = tile;
            BodyDef body = slider(0, 0.3, floor, 0.1, 3.0);
            body.spin = -3.0 / 0.3;
            const BodyState end = end_of(on_floor(floor, false, body, e, 0.5, k_field), EngineChoice::automatic, 4.0);
            CAPTURE(e);
            CHECK(std::abs(end.velocity.x() - 3.0) < 3e-9);
        }
    }
}

TEST_CASE("a row of flush bricks that move carries a box as one slab does")
{
    for (const int count : {4, 10, 40}) {
        for (const double e : {0.0, 0.5}) {
            const double width = count == 40 ? 1.0 / 3.0 : 0.5;
            Scene scene;
            scene.world.field = k_field;
            scene.world.restitution = e;
            scene.bodies.push_back(still(rectangle(100.0, 1.0, Vec2(0.0, -0.5))));
            scene.bodies.push_back(still(rectangle(20.0, 0.3, Vec2(-10.0, 0.15))));
            scene.bodies.push_back(still(rectangle(20.0, 0.3, Vec2(count * width + 10.0, 0.15))));
            for (int k = 0; k < count; ++k) scene.bodies.push_back(rectangle(width, 0.3, Vec2((k + 0.5) * width, 0.15)));
            scene.bodies.push_back(rectangle(0.8, 0.4, Vec2(-1.3, 0.5), Vec2(3.0, 0.0)));
            const BodyState end = end_of(scene, EngineChoice::automatic, 1.5);
            CAPTURE(count);
            CAPTURE(e);
            CHECK((end.position - Vec2(3.2, 0.5)).norm() < 1e-9);
            CHECK((end.velocity - Vec2(3.0, 0.0)).norm() < 1e-9);
        }
    }
}

TEST_CASE("a step of a millimetre stops a box, and a wall on the tiles is a wall")
{
    for (const double height : {1e-3, 0.5}) {
        for (const double e : {0.0, 0.5}) {
            Floor floor;
            Scene scene = on_floor(floor, false, slider(4, 0.5, floor, 0.0, 3.0), e, 0.0, k_field);
            BodyDef step = still(rectangle(10.0, 0.3, Vec2(9.0, height - 0.15)));
            if (height > 0.1) step = still(rectangle(1.0, height, Vec2(4.5, 0.5 * height)));
            else std::erase_if(scene.bodies, [](const BodyDef& body) { return body.is_static && body.position.x() > 4.0; });
            scene.bodies.insert(scene.bodies.begin(), step);
            const BodyState end = end_of(scene, EngineChoice::automatic, 1.5);
            CAPTURE(height);
            CHECK(end.position.x() < 4.0);
            CHECK(end.velocity.x() < 1.0);
            if (height > 0.1) CHECK(end.velocity.x() == doctest::Approx(-3.0 * e).epsilon(1e-9));
        }
    }
}
