#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "geometry/convex_parts.hpp"
#include "math/orientation.hpp"
#include "support/random_polygons.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Every corner of every part turns left or goes straight on, decided exactly (a polygon that is convex to rounding is
/// left as it is); and areas add up.
void check_parts(const Polygon& polygon, const std::vector<Polygon>& parts)
{
    double sum = 0.0;
    for (const Polygon& part : parts) {
        const int count = static_cast<int>(part.vertices().size());
        for (int v = 0; v < count; ++v) {
            const Vec2& before = part.vertices()[(v + count - 1) % count];
            const Vec2& after = part.vertices()[(v + 1) % count];
            if (!polygon.is_convex()) CHECK(orientation(before, part.vertices()[v], after) >= 0);
        }
        CHECK(area_of_polygon(part) > 0.0);
        sum += area_of_polygon(part);
    }
    const double area = area_of_polygon(polygon);
    CHECK(std::abs(sum - area) <= 1e-14 * area * static_cast<double>(parts.size()));
}

Polygon comb(int teeth)
{
    std::vector<Vec2> ring = {Vec2(0.0, -1.0), Vec2(2.0 * teeth - 1.0, -1.0)};
    for (int k = teeth - 1; k >= 0; --k) {
        ring.push_back(Vec2(2.0 * k + 1.0, 3.0));
        ring.push_back(Vec2(2.0 * k, 3.0));
        if (k > 0) ring.push_back(Vec2(2.0 * k, 0.0));
        if (k > 0) ring.push_back(Vec2(2.0 * k - 1.0, 0.0));
    }
    return Polygon({ring});
}

} // namespace

TEST_CASE("a convex polygon is its own only part")
{
    Random random(601);
    for (int k = 0; k < 100; ++k) {
        const Polygon polygon = random_convex(random);
        const std::vector<Polygon> parts = convex_parts(polygon);
        REQUIRE(parts.size() == 1);
        CHECK(parts[0].vertices().size() == polygon.vertices().size());
    }
}

TEST_CASE(
    "an L falls into two parts, a comb into one for each tooth and one for its back at best, four times that at most")
{
    const Polygon l({{Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(1, 1), Vec2(1, 2), Vec2(0, 2)}});
    const std::vector<Polygon> parts = convex_parts(l);
    CHECK(parts.size() == 2);
    check_parts(l, parts);

    for (const int teeth : {2, 3, 10, 60}) {
        const Polygon polygon = comb(teeth);
        const std::vector<Polygon> pieces = convex_parts(polygon);
        check_parts(polygon, pieces);
        CHECK(pieces.size() <= static_cast<std::size_t>(4 * (teeth + 1)));
    }
}

TEST_CASE("parts of random polygons, with holes and with vertices on straight edges, cover them without gap or overlap")
{
    Random random(602);
    for (int k = 0; k < 2000; ++k) {
        const Polygon polygon = random_star(random, k % 2 == 0);
        const std::vector<Polygon> parts = convex_parts(polygon);
        check_parts(polygon, parts);

        // Convex parts whose areas add up overlap nowhere if every point of the polygon is in one of them
        for (int i = 0; i < 20; ++i) {
            const Vec2 point{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
            int holders = 0;
            for (const Polygon& part : parts) holders += contains(part, Pose(), point) ? 1 : 0;
            CHECK(holders == (contains(polygon, Pose(), point) ? 1 : 0));
        }
    }
}

TEST_CASE("a plate with many holes in rows, all corners on common lines, is cut up")
{
    std::vector<std::vector<Vec2>> rings = {{Vec2(0, 0), Vec2(13, 0), Vec2(13, 13), Vec2(0, 13)}};
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            const double x = 1.0 + 2.0 * i;
            const double y = 1.0 + 2.0 * j;
            rings.push_back({Vec2(x, y), Vec2(x, y + 1.0), Vec2(x + 1.0, y + 1.0), Vec2(x + 1.0, y)});
        }
    }
    const Polygon plate(rings);
    check_parts(plate, convex_parts(plate));
    CHECK(area_of_polygon(plate) == 169.0 - 36.0);
}

TEST_CASE("holes that see the outer ring only past one another are joined to it")
{
    // Three bars, one behind the other, in a box that they nearly fill
    std::vector<std::vector<Vec2>> rings = {{Vec2(0, 0), Vec2(8, 0), Vec2(8, 8), Vec2(0, 8)}};
    for (const double x : {1.0, 3.0, 5.0}) {
        rings.push_back({Vec2(x, 0.001), Vec2(x, 7.999), Vec2(x + 1.0, 7.999), Vec2(x + 1.0, 0.001)});
    }
    const Polygon polygon(rings);
    check_parts(polygon, convex_parts(polygon));
}

TEST_CASE("a spiral and a saw of a thousand teeth are cut up")
{
    std::vector<Vec2> ring;
    std::vector<Vec2> back;
    for (int k = 0; k <= 120; ++k) {
        const double angle = 0.15 * k;
        const Vec2 direction(std::cos(angle), std::sin(angle));
        ring.push_back((1.0 + 0.3 * angle) * direction);
        back.push_back((0.5 + 0.3 * angle) * direction);
    }
    ring.insert(ring.end(), back.rbegin(), back.rend());
    const Polygon spiral({ring});
    REQUIRE(area_of_polygon(spiral) > 0.0);
    check_parts(spiral, convex_parts(spiral));

    std::vector<Vec2> saw = {Vec2(0.0, -1.0), Vec2(1000.0, -1.0)};
    for (int k = 1000; k > 0; --k) {
        saw.push_back(Vec2(k, 0.0));
        saw.push_back(Vec2(k - 0.5, 1.0));
    }
    saw.push_back(Vec2(0.0, 0.0));
    const Polygon polygon({saw});
    check_parts(polygon, convex_parts(polygon));
}

TEST_CASE("vertices that miss a common line by a rounding are no harm")
{
    Random random(603);
    for (int k = 0; k < 300; ++k) {
        // A slab whose long sides carry vertices that are off by an ulp or two, and a notch
        std::vector<Vec2> ring;
        const Rotation turn = Rotation::of(random.uniform(-3.0, 3.0));
        for (int i = 0; i < 10; ++i) ring.push_back(turn * Vec2(0.1 * i, 0.0));
        ring.push_back(turn * Vec2(1.0, 0.0));
        for (int i = 10; i > 5; --i) ring.push_back(turn * Vec2(0.1 * i, 0.3));
        ring.push_back(turn * Vec2(0.5, 0.1));
        for (int i = 4; i >= 0; --i) ring.push_back(turn * Vec2(0.1 * i, 0.3));
        const Polygon polygon({ring});
        check_parts(polygon, convex_parts(polygon));
    }
}
