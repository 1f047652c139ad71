// The inner corners of a comb stand in one row, as do those of an H, or of a plate with a row of holes. Turned anyhow,
// they stand on one line but for rounding; and the cuts into convex parts left slivers between them, as wide as a
// rounding, whose normals were noise. What came near such a body was put away from it by metres before it touched.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "geometry/convex_parts.hpp"
#include "geometry/make_polygon.hpp"
#include "math/random.hpp"
#include "support/effort.hpp"
#include "support/overlap.hpp"
#include "support/worlds.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

using Rings = std::vector<std::vector<Vec2>>;

/// Teeth up from a back; both edges of the back are 0.2 apart.
Rings comb(int teeth)
{
    std::vector<Vec2> ring = {Vec2(0.0, -0.2), Vec2(teeth - 0.5, -0.2)};
    for (int k = teeth - 1; k >= 0; --k) {
        if (k < teeth - 1) ring.emplace_back(k + 0.5, 0.0);
        ring.emplace_back(k + 0.5, 0.7);
        ring.emplace_back(k, 0.7);
        if (k > 0) ring.emplace_back(k, 0.0);
    }
    return {ring};
}

Rings letter_h(int)
{
    return {{Vec2(-1.0, -1.0), Vec2(-0.6, -1.0), Vec2(-0.6, -0.15), Vec2(0.6, -0.15), Vec2(0.6, -1.0), Vec2(1.0, -1.0),
             Vec2(1.0, 1.0), Vec2(0.6, 1.0), Vec2(0.6, 0.15), Vec2(-0.6, 0.15), Vec2(-0.6, 1.0), Vec2(-1.0, 1.0)}};
}

Rings plate(int holes)
{
    Rings rings = {{Vec2(0.0, 0.0), Vec2(holes, 0.0), Vec2(holes, 1.0), Vec2(0.0, 1.0)}};
    for (int k = 0; k < holes; ++k)
        rings.push_back({Vec2(k + 0.3, 0.3), Vec2(k + 0.3, 0.7), Vec2(k + 0.7, 0.7), Vec2(k + 0.7, 0.3)});
    return rings;
}

Rings turned(Rings rings, double angle, double size)
{
    const Rotation turn = Rotation::of(angle);
    for (std::vector<Vec2>& ring : rings) {
        for (Vec2& vertex : ring) vertex = size * (turn * vertex);
    }
    return rings;
}

/// Coordinates as a file has them that keeps so many digits.
///
/// step  of the last digit; 0 for all digits [m]
Rings written(Rings rings, double step)
{
    for (std::vector<Vec2>& ring : rings) {
        for (Vec2& vertex : ring) {
            if (step > 0.0) vertex = step * Vec2(std::round(vertex.x() / step), std::round(vertex.y() / step));
        }
    }
    return rings;
}

PolygonDef as_shape(const Rings& rings)
{
    return {rings[0], {rings.begin() + 1, rings.end()}};
}

double area_of(const Polygon& polygon)
{
    double area = 0.0;
    for (const Edge& edge : polygon.edges())
        area += 0.5 * cross(polygon.vertices()[edge.from], polygon.vertices()[edge.to]);
    return area;
}

/// The least distance between two parallel lines that have a convex polygon between them.
double width_of(const Polygon& polygon)
{
    double width = std::numeric_limits<double>::infinity();
    for (const Edge& edge : polygon.edges()) {
        double deepest = 0.0;
        for (const Vec2& vertex : polygon.vertices())
            deepest = std::max(deepest, edge.normal.dot(polygon.vertices()[edge.from] - vertex));
        width = std::min(width, deepest);
    }
    return width;
}

} // namespace

TEST_CASE("bodies with corners in a row are cut into parts without slivers, however they are turned")
{
    Random random(5501);
    for (Rings (*const make)(int) : {comb, letter_h, plate}) {
        for (int k = 0; k < 300; ++k) {
            CAPTURE(k);
            const double size = std::exp(random.uniform(-5.0, 5.0));
            const Rings rings = turned(make(2 + k % 7), random.uniform(0.0, 6.3), size);
            const std::vector<std::vector<Vec2>> holes(rings.begin() + 1, rings.end());
            const Polygon polygon = make_polygon(rings[0], holes).value().polygon;
            double area = 0.0;
            for (const Polygon& part : convex_parts(polygon)) {
                area += area_of(part);
                CHECK(width_of(part) >= 0.01 * size);
            }
            CHECK(area == doctest::Approx(area_of(polygon)).epsilon(1e-12));
        }
    }
}

TEST_CASE("what drifts towards a body with corners in a row meets it where its surface is")
{
    Random random(5502);
    for (Rings (*const make)(int) : {comb, letter_h, plate}) {
        for (int k = 0; k < tried(60); ++k) {
            CAPTURE(k);
            const double angle = random.uniform(0.0, 6.3);
            Scene scene;
            scene.world.restitution = 0.0;
            scene.world.friction = 0.0;
            BodyDef body;
            const double step = k % 12 == 0 ? 0.0 : std::pow(10.0, -(k % 12) - 5.0);
            body.shape = as_shape(written(turned(make(3), angle, 1.0), step));
            scene.bodies.push_back(body);
            BodyDef bar = rectangle(0.3, 2.0, {-4.0, random.uniform(-1.0, 1.0)}, {4.0, 0.0});
            bar.angle = random.uniform(0.0, 3.0);
            scene.bodies.push_back(bar);
            World world = world_of(scene, EngineChoice::rest);
            const double before = world.report().momentum.x();
            for (int frame = 1; frame <= 90; ++frame) {
                run(world, frame / 60.0);
                CHECK(deepest_overlap(world) <= 0.01);
            }
            CHECK(world.report().momentum.x() == doctest::Approx(before).epsilon(1e-12));
        }
    }
}
