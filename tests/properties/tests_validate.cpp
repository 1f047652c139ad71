#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/moments.hpp"
#include "math/random.hpp"
#include "world/make_shape.hpp"
#include "world/scene.hpp"

using namespace flying;

namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_denormal = std::numeric_limits<double>::denorm_min();

BodyDef disc(std::string name, double x, double y, double radius = 0.5)
{
    BodyDef body;
    body.name = std::move(name);
    body.shape = DiscDef{radius};
    body.position = Vec2(x, y);
    return body;
}

/// Four bodies of all kinds in a box, with nothing wrong.
Scene good_scene()
{
    Scene scene;
    scene.title = "four bodies";
    scene.world.field = UniformField{Vec2(0.0, -9.81)};
    scene.world.box = BoxDef{Vec2(-10.0, 0.0), Vec2(10.0, 10.0)};
    scene.bodies = {disc("ball", -3.0, 5.0), disc("crate", 0.0, 5.0), disc("plate", 3.0, 5.0), disc("shelf", 0.0, 1.0)};
    scene.bodies[1].shape = RectangleDef{2.0, 1.0};
    scene.bodies[1].mass = 4.0;
    scene.bodies[2].shape = PolygonDef{{Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(1, 1), Vec2(1, 2), Vec2(0, 2)}, {}};
    scene.bodies[2].restitution = 0.5;
    scene.bodies[3].shape = SquareDef{1.0};
    scene.bodies[3].is_static = true;
    return scene;
}

bool has_fault_at(const Faults& faults, const std::string& place)
{
    return std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) { return fault.place == place; });
}

std::string all_places(const Faults& faults)
{
    std::string text;
    for (const Fault& fault : faults) text += fault.place + ": " + fault.found + " | " + fault.expected + "\n";
    return text;
}

struct Spoiled
{
    const char* place; ///< of the one fault that is expected
    std::function<void(Scene&)> spoil;
};

} // namespace

TEST_CASE("a good scene has no faults, and bodies may touch each other and the box")
{
    Scene scene = good_scene();
    CHECK(all_places(validate(scene)) == "");

    // On the floor, in the corner, side by side, standing on one another; minus zero is zero
    scene.bodies[0].position = Vec2(-9.5, 0.5);
    scene.bodies[1].position = Vec2(-8.0, 0.5);
    scene.bodies[2].velocity = Vec2(-0.0, -0.0);
    scene.bodies[2].spin = -0.0;
    scene.bodies[2].angle = -0.0;
    CHECK(all_places(validate(scene)) == "");
    CHECK(validate(Scene{}).empty());
}

TEST_CASE("static bodies may stick out of the box and into each other")
{
    Scene scene = good_scene();
    scene.bodies[3].position = Vec2(0.0, 0.0);
    scene.bodies.push_back(scene.bodies[3]);
    scene.bodies[4].name = "another";
    scene.bodies[4].position = Vec2(0.25, -0.25);
    CHECK(all_places(validate(scene)) == "");
}

TEST_CASE("every single thing that can be wrong with a scene is found, at its place, and alone")
{
    const std::vector<Spoiled> cases = {
        {"until", [](Scene& s) { s.until = -1.0; }},
        {"until", [](Scene& s) { s.until = k_nan; }},
        {"until", [](Scene& s) { s.until = k_infinity; }},
        {"world.restitution", [](Scene& s) { s.world.restitution = 1.5; }},
        {"world.restitution", [](Scene& s) { s.world.restitution = -0.1; }},
        {"world.restitution", [](Scene& s) { s.world.restitution = k_nan; }},
        {"world.friction", [](Scene& s) { s.world.friction = -0.1; }},
        {"world.friction", [](Scene& s) { s.world.friction = k_infinity; }},
        {"world.field.gravity[0]", [](Scene& s) { s.world.field = UniformField{Vec2(k_nan, 0.0)}; }},
        {"world.field.gravity[1]", [](Scene& s) { s.world.field = UniformField{Vec2(0.0, 1e300)}; }},
        {"world.box.min[1]", [](Scene& s) { s.world.box->min.y() = -k_infinity; }},
        {"world.box.max[0]", [](Scene& s) { s.world.box->max.x() = -10.0; }},
        {"world.box.max[1]", [](Scene& s) { s.world.box->max.y() = -3.0; }},
        {"body[1].name", [](Scene& s) { s.bodies[1].name = "ball"; }},
        {"body[0].position[0]", [](Scene& s) { s.bodies[0].position.x() = k_nan; }},
        {"body[0].position[1]", [](Scene& s) { s.bodies[0].position.y() = -1e308; }},
        {"body[0].position[1]", [](Scene& s) { s.bodies[0].position.y() = k_denormal; }},
        {"body[1].angle", [](Scene& s) { s.bodies[1].angle = k_infinity; }},
        {"body[1].angle", [](Scene& s) { s.bodies[1].angle = 1e16; }},
        {"body[2].velocity[0]", [](Scene& s) { s.bodies[2].velocity.x() = k_nan; }},
        {"body[2].velocity[1]", [](Scene& s) { s.bodies[2].velocity.y() = 1e200; }},
        {"body[2].spin", [](Scene& s) { s.bodies[2].spin = -k_infinity; }},
        {"body[2].spin", [](Scene& s) { s.bodies[2].spin = k_denormal; }},
        {"body[0].density", [](Scene& s) { s.bodies[0].density = 0.0; }},
        {"body[0].density", [](Scene& s) { s.bodies[0].density = -2.0; }},
        {"body[0].density", [](Scene& s) { s.bodies[0].density = k_nan; }},
        {"body[1].density", [](Scene& s) { s.bodies[1].density = 1.0; }}, // has a mass already
        {"body[1].mass", [](Scene& s) { s.bodies[1].mass = 0.0; }},
        {"body[1].mass", [](Scene& s) { s.bodies[1].mass = k_infinity; }},
        {"body[1].mass", [](Scene& s) { s.bodies[1].mass = 1e-308; }},
        {"body[3].mass", [](Scene& s) { s.bodies[3].mass = 1.0; }},
        {"body[3].velocity", [](Scene& s) { s.bodies[3].velocity = Vec2(0.0, 1.0); }},
        {"body[3].spin", [](Scene& s) { s.bodies[3].spin = 1.0; }},
        {"body[2].restitution", [](Scene& s) { s.bodies[2].restitution = 2.0; }},
        {"body[2].friction", [](Scene& s) { s.bodies[2].friction = -1.0; }},
        {"body[0].shape.radius", [](Scene& s) { s.bodies[0].shape = DiscDef{0.0}; }},
        {"body[0].shape.radius", [](Scene& s) { s.bodies[0].shape = DiscDef{k_nan}; }},
        {"body[0].shape.radius", [](Scene& s) { s.bodies[0].shape = DiscDef{1e300}; }},
        {"body[1].shape.width",
         [](Scene& s) {
             s.bodies[1].shape = RectangleDef{-1.0, 1.0};
         }},
        {"body[1].shape.height",
         [](Scene& s) {
             s.bodies[1].shape = RectangleDef{1.0, 1e-308};
         }},
        {"body[1].shape.side", [](Scene& s) { s.bodies[1].shape = SquareDef{k_infinity}; }},
        {"body[1].shape.sides[1]",
         [](Scene& s) {
             s.bodies[1].shape = TriangleDef{{1.0, 0.0}, 1.0};
         }},
        {"body[1].shape.angle",
         [](Scene& s) {
             s.bodies[1].shape = TriangleDef{{1.0, 1.0}, 0.0};
         }},
        {"body[1].shape.angle",
         [](Scene& s) {
             s.bodies[1].shape = TriangleDef{{1.0, 1.0}, std::numbers::pi};
         }},
        {"body[1].shape.angle",
         [](Scene& s) {
             s.bodies[1].shape = TriangleDef{{1.0, 1.0}, k_nan};
         }},
        {"body[1].shape.angle",
         [](Scene& s) {
             s.bodies[1].shape = TriangleDef{{1.0, 1.0}, 1e-18};
         }},
        {"body[1].shape.sides",
         [](Scene& s) {
             s.bodies[1].shape = RegularDef{2, 1.0};
         }},
        {"body[1].shape.sides",
         [](Scene& s) {
             s.bodies[1].shape = RegularDef{-2000000000, 1.0};
         }},
        {"body[1].shape.sides",
         [](Scene& s) {
             s.bodies[1].shape = RegularDef{2000000000, 1.0};
         }},
        {"body[1].shape.radius",
         [](Scene& s) {
             s.bodies[1].shape = RegularDef{5, -1.0};
         }},
        {"body[2].shape.vertices[1][0]",
         [](Scene& s) { std::get<PolygonDef>(s.bodies[2].shape).vertices[1].x() = k_nan; }},
        {"body[2].shape.holes[0][2][1]",
         [](Scene& s) {
             std::get<PolygonDef>(s.bodies[2].shape).holes = {{Vec2(0.1, 0.1), Vec2(0.3, 0.1), Vec2(0.2, 1e200)}};
         }},
        {"body[2].shape.vertices", [](Scene& s) { s.bodies[2].shape = PolygonDef{}; }},
        {"body[0].position", [](Scene& s) { s.bodies[0].position = Vec2(-9.75, 5.0); }},
        {"body[0].position", [](Scene& s) { s.bodies[0].position = Vec2(50.0, 5.0); }},
        {"body[1].position", [](Scene& s) { s.bodies[1].position = Vec2(-2.0, 5.0); }}, // on the ball
        {"body[3].position", [](Scene& s) { s.bodies[3].position = Vec2(0.0, 5.5); }},  // static, on the crate
    };
    CHECK(cases.size() >= 25);
    for (const Spoiled& spoiled : cases) {
        CAPTURE(spoiled.place);
        Scene scene = good_scene();
        spoiled.spoil(scene);
        const Faults faults = validate(scene);
        CAPTURE(all_places(faults));
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].place == spoiled.place);
        CHECK_FALSE(faults[0].found.empty());
        CHECK_FALSE(faults[0].expected.empty());
    }
}

TEST_CASE("a scene with many faults gets them all in one go")
{
    Scene scene = good_scene();
    scene.until = -1.0;
    scene.world.restitution = 2.0;
    scene.world.friction = k_nan;
    scene.bodies[0].shape = DiscDef{-1.0};
    scene.bodies[0].velocity = Vec2(k_nan, k_infinity);
    scene.bodies[1].name = "ball";
    scene.bodies[1].mass = -4.0;
    scene.bodies[1].density = -1.0;
    scene.bodies[2].shape = RectangleDef{0.0, k_nan};
    scene.bodies[3].spin = 2.0;
    scene.bodies[3].mass = 2.0;
    scene.bodies.push_back(disc("left", -5.0, 9.75));
    scene.bodies.push_back(disc("right", -4.25, 9.0));
    scene.bodies.push_back(disc("", -4.25, 9.0, 0.25));
    const Faults faults = validate(scene);
    CAPTURE(all_places(faults));
    for (const char* place :
         {"until", "world.restitution", "world.friction", "body[0].shape.radius", "body[0].velocity[0]",
          "body[0].velocity[1]", "body[1].name", "body[1].mass", "body[1].density", "body[2].shape.width",
          "body[2].shape.height", "body[3].spin", "body[3].mass", "body[4].position", "body[6].position"}) {
        CAPTURE(place);
        CHECK(has_fault_at(faults, place));
    }
    // Two more where one place has several: mass with density, and the third disc within the second
    CHECK(faults.size() >= 16);
}

TEST_CASE("an overlap names both bodies and the depth, a body outside names the side of the box")
{
    Scene scene;
    scene.bodies = {disc("right", 0.75, 0.0), disc("left", 0.0, 0.0)};
    Faults faults = validate(scene);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].place == "body[1].position");
    CHECK(faults[0].found == "\"left\" overlaps \"right\" by 0.25 m");
    CHECK(faults[0].expected == "bodies that at most touch");

    scene.bodies[0].name = "";
    scene.bodies[1].position = Vec2(9.0, 0.0);
    scene.world.box = BoxDef{Vec2(0.5, -5.0), Vec2(20.0, 5.0)};
    faults = validate(scene);
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].found == "body 0 reaches through the left side of the box by 0.25 m");
}

TEST_CASE("a small overlap of decimal numbers is rounding, a millionth of the size is a fault")
{
    for (const double scale : {1e-30, 1e-6, 1.0, 1e30}) {
        Scene scene;
        scene.bodies = {disc("a", 0.1 * scale, 0.7 * scale, 0.1 * scale),
                        disc("b", 0.3 * scale, 0.7 * scale, 0.1 * scale)};
        CHECK(validate(scene).empty());
        scene.bodies[1].position.x() = (0.3 - 1e-7) * scale;
        CHECK(validate(scene).size() == 1);
    }
    // A tiny body may touch a large one although the large one's rounding is not small to it
    Scene scene;
    scene.bodies = {disc("planet", 1000.1, 0.0, 1000.0), disc("grain", 0.1 - 1e-7, 0.0, 1e-7)};
    CHECK(validate(scene).empty());
    scene.bodies[1].position.x() += 1e-9;
    CHECK(validate(scene).size() == 1);
}

TEST_CASE("bodies in holes, in notches and between walls are told from bodies that overlap")
{
    Scene scene;
    scene.bodies = {disc("frame", 0.0, 0.0), disc("ball", 0.0, 0.0, 1.0)};
    scene.bodies[0].shape = PolygonDef{{Vec2(-2, -2), Vec2(2, -2), Vec2(2, 2), Vec2(-2, 2)},
                                       {{Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}}};
    CHECK(all_places(validate(scene)) == "");
    scene.bodies[1].position.x() = 0.01;
    CHECK(validate(scene).size() == 1);
    scene.bodies[1].shape = DiscDef{0.01};
    scene.bodies[1].position.x() = 1.5;
    CHECK(validate(scene).size() == 1);
}

namespace {

/// Pairs of discs, not both static, nearer to each other than their radii together.
std::size_t count_overlaps(const std::vector<BodyDef>& discs)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double reach = std::get<DiscDef>(discs[i].shape).radius + std::get<DiscDef>(discs[j].shape).radius;
            const bool both_static = discs[i].is_static && discs[j].is_static;
            count += (discs[i].position - discs[j].position).norm() < reach && !both_static ? 1 : 0;
        }
    }
    return count;
}

} // namespace

TEST_CASE("every overlapping pair of a crowd is found, whatever the direction of the crowd")
{
    Random random(701);
    for (int round = 0; round < 20; ++round) {
        Scene scene;
        const double width = round % 2 == 0 ? 60.0 : 4.0;
        const double height = round % 2 == 0 ? 4.0 : 60.0;
        for (int k = 0; k < 120; ++k) {
            const double x = random.uniform(0.0, width);
            const double y = random.uniform(0.0, height);
            scene.bodies.push_back(disc("", x, y, random.uniform(0.1, 0.8)));
            scene.bodies.back().is_static = k % 5 == 0;
        }
        CHECK(validate(scene).size() == count_overlaps(scene.bodies));
    }
}

TEST_CASE("every overlapping pair is found among bodies of all sizes, near the origin and far from it")
{
    Random random(702);
    for (int round = 0; round < 40; ++round) {
        Scene scene;
        const Vec2 origin = round % 2 == 0 ? Vec2(0.0, 0.0) : Vec2(-3e6, 5e6);
        const double unit = round % 3 == 0 ? 0.25 : 0.3; // with the first, boxes are as long as powers of two
        for (int k = 0; k < 300; ++k) {
            const double x = random.uniform(-40.0, 40.0);
            const double y = random.uniform(-40.0, 40.0);
            const int halvings = std::min(random.below(8), random.below(8));
            scene.bodies.push_back(disc("", origin.x() + x, origin.y() + y, unit * std::ldexp(1.0, 4 - halvings)));
            scene.bodies.back().is_static = k % 5 == 0;
        }
        const std::size_t expected = count_overlaps(scene.bodies);
        REQUIRE(expected < 1000);
        CHECK(expected > 100);
        CHECK(validate(scene).size() == expected);
    }
}

TEST_CASE("ten thousand bodies in one place are refused without listing fifty million pairs")
{
    Scene scene;
    for (int k = 0; k < 10000; ++k) scene.bodies.push_back(disc("", 0.0, 0.0));
    const Faults faults = validate(scene);
    CHECK(faults.size() > 100);
    CHECK(faults.size() < 20000);
}

TEST_CASE("ten thousand bodies on a lattice, all touching, are a good scene")
{
    Scene scene;
    for (int i = 0; i < 100; ++i) {
        for (int j = 0; j < 100; ++j) {
            scene.bodies.push_back(disc("", 0.1 * i, 0.1 * j, 0.05));
            if ((i + j) % 2 == 0) scene.bodies.back().shape = SquareDef{0.1};
        }
    }
    CHECK(all_places(validate(scene)) == "");
}

TEST_CASE("rectangles and regular polygons are about their centres to the bit")
{
    const Shape rectangle = make_shape(RectangleDef{0.3, 0.7}).value();
    const std::span<const Vec2> corners = std::get<Polygon>(rectangle).vertices();
    REQUIRE(corners.size() == 4);
    for (const Vec2& corner : corners) {
        CHECK(std::abs(corner.x()) == 0.15);
        CHECK(std::abs(corner.y()) == 0.35);
    }

    for (const int sides : {3, 4, 5, 6, 7, 8, 12, 17, 100, 1000}) {
        const Shape shape = make_shape(RegularDef{sides, 0.7}).value();
        const Polygon& polygon = std::get<Polygon>(shape);
        const std::span<const Vec2> vertices = polygon.vertices();
        REQUIRE(static_cast<int>(vertices.size()) == sides);
        CHECK(polygon.is_convex());
        CHECK(vertices[0] == Vec2(0.7, 0.0));
        for (int k = 0; k < sides; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / sides;
            CHECK((vertices[k] - 0.7 * Vec2(std::cos(angle), std::sin(angle))).norm() <= 1e-15);
            // Mirrored in the x axis; for an even number also in the centre, for a multiple of four turned by a quarter
            const Vec2& mirrored = vertices[(sides - k) % sides];
            CHECK(mirrored == Vec2(vertices[k].x(), -vertices[k].y()));
            if (sides % 2 == 0) CHECK(vertices[(k + sides / 2) % sides] == -vertices[k]);
            if (sides % 4 == 0) CHECK(vertices[(k + sides / 4) % sides] == perp(vertices[k]));
        }
    }
    CHECK(std::get<Polygon>(make_shape(RegularDef{1000000, 1.0}).value()).is_convex());
}

TEST_CASE("triangles and polygons are moved to their centroids")
{
    const Shape triangle = make_shape(TriangleDef{{3.0, 4.0}, std::numbers::pi / 2.0}).value();
    const Polygon& polygon = std::get<Polygon>(triangle);
    CHECK(moments_of(polygon).area == doctest::Approx(6.0));
    CHECK(moments_of(polygon).centroid.norm() <= 1e-15);
    CHECK(polygon.vertices()[0].isApprox(Vec2(-1.0, -4.0 / 3.0), 1e-15));
    CHECK((polygon.vertices()[1] - polygon.vertices()[0]).isApprox(Vec2(3.0, 0.0), 1e-15));

    const Shape far =
        make_shape(PolygonDef{{Vec2(100, 100), Vec2(100, 102), Vec2(103, 102), Vec2(103, 100)}, {}}).value();
    CHECK(moments_of(std::get<Polygon>(far)).area == doctest::Approx(6.0));
    CHECK(moments_of(std::get<Polygon>(far)).centroid.norm() <= 1e-15);
}

TEST_CASE("a body is called by its name, or by its number")
{
    Scene scene;
    scene.bodies = {disc("ball", 0.0, 0.0), disc("", 5.0, 0.0)};
    CHECK(body_label(scene, 0) == "ball");
    CHECK(body_label(scene, 1) == "body 1");
}
