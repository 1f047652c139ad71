#include "geometry/moments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

#include "chapters/04-arbitrary-polygon/exact_moments.hpp"
#include "mass/polygon.hpp"
#include "../../../chapters/02-rectangle/rectangle.hpp"
#include "../../../chapters/03-regular-polygon/regular_polygon.hpp"
#include "math/random.hpp"
#include "math/sine_cosine.hpp"

using namespace flying;

namespace {

using Ring = std::vector<Vec2>;

double relative(double found, double expected)
{
    return std::abs(found - expected) / std::abs(expected);
}

Ring moved(Ring ring, const Vec2& offset)
{
    for (Vec2& vertex : ring) vertex += offset;
    return ring;
}

const Ring k_dumbbell = {{40, 20},   {40, 40},   {80, 40},   {80, -40}, {40, -40}, {40, -20},
                         {-40, -20}, {-40, -40}, {-80, -40}, {-80, 40}, {-40, 40}, {-40, 20}};

const Ring k_house = {{0, 0}, {100, 0}, {100, 100}, {50, 150}, {0, 100}};

/// A star-shaped ring with whole coordinates: points on rays in the order of their angles. Rounding to whole numbers
/// keeps it nearly star-shaped; that it is simple does not matter to signed triangles.
Ring random_star(Random& random, int count, double radius)
{
    Ring ring;
    for (int k = 0; k < count; ++k) {
        const double angle = 2.0 * std::numbers::pi * (k + random.uniform(0.1, 0.9)) / count;
        const double distance = radius * random.uniform(0.1, 1.0);
        const SineCosine sc = sine_cosine(angle);
        ring.push_back(Vec2(std::round(distance * sc.cosine), std::round(distance * sc.sine)));
    }
    return ring;
}

/// A comb: monotone in x, with teeth of random lengths, its area a small part of its box.
Ring random_comb(Random& random, int teeth, int height)
{
    Ring ring;
    for (int k = 0; k <= teeth; ++k) ring.push_back(Vec2(10.0 * k, -1.0));
    for (int k = teeth; k > 0; --k) {
        ring.push_back(Vec2(10.0 * k, 0.0));
        ring.push_back(Vec2(10.0 * k - 5.0, 1.0 + random.below(height)));
        ring.push_back(Vec2(10.0 * k - 9.0, 0.0));
    }
    ring.push_back(Vec2(0.0, 0.0));
    return ring;
}

/// The greatest error of area, centroid and second moment.  [ulp]
double worst_error(const AreaMoments& found, const oracle::Moments& exact)
{
    double worst =
        std::max(oracle::ulps(found.area, exact.area), oracle::ulps(found.second_moment, exact.second_moment));
    worst = std::max(worst, oracle::ulps(found.centroid.x(), exact.x));
    return std::max(worst, oracle::ulps(found.centroid.y(), exact.y));
}

} // namespace

TEST_CASE("a triangle has m (a^2 + b^2 + c^2) / 36")
{
    Random random(41);
    for (int k = 0; k < 1000; ++k) {
        Ring ring;
        for (int v = 0; v < 3; ++v) ring.push_back(Vec2{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
        const AreaMoments moments = moments_of_ring(ring);
        double sides = 0.0;
        for (int v = 0; v < 3; ++v) sides += (ring[(v + 1) % 3] - ring[v]).squaredNorm();

        // The closed form has a few roundings of its own
        REQUIRE(relative(moments.second_moment, moments.area * sides / 36.0) < 4.0 * 0x1p-52);
        REQUIRE((moments.centroid - (ring[0] + ring[1] + ring[2]) / 3.0).norm() < 4.0 * 0x1p-52);
    }
}

TEST_CASE("a rectangle has m (w^2 + h^2) / 12, wherever it lies")
{
    const Ring ring = {{0, 0}, {3, 0}, {3, 4}, {0, 4}};
    for (const Vec2& offset : {Vec2(0.0, 0.0), Vec2(-1.5, -2.0), Vec2(1e8, -3e8), Vec2(1e15, 1e15)}) {
        const AreaMoments moments = moments_of_ring(moved(ring, offset));
        CHECK(moments.area == 12.0);
        CHECK(moments.second_moment == 25.0);
        CHECK(moments.centroid == Vec2(1.5 + offset.x(), 2.0 + offset.y()));
    }
}

TEST_CASE("the dumbbell's area is 9,600, not the 12,800 of triangles without sign")
{
    const AreaMoments moments = moments_of_ring(k_dumbbell);
    CHECK(std::abs(moments.area) == 9600.0);
    CHECK(moments.centroid == Vec2(0.0, 0.0));

    // Two plates of 40 x 80 about their own middles, 60 away, and a bar of 80 x 40
    const double plates = 2.0 * about_parallel_axis(rectangle_mass(40.0, 80.0, 1.0), 60.0);
    const double bar = rectangle_mass(80.0, 40.0, 1.0).moment_of_inertia;
    CHECK(relative(std::abs(moments.second_moment), plates + bar) < 2.0 * 0x1p-52);
}

TEST_CASE("triangles without sign would make the dumbbell a third larger")
{
    // The wrong way: absolute areas about the middle. Here is what the sign is for
    double area = 0.0;
    double second = 0.0;
    for (std::size_t k = 0; k < k_dumbbell.size(); ++k) {
        const Vec2& a = k_dumbbell[k];
        const Vec2& b = k_dumbbell[(k + 1) % k_dumbbell.size()];
        area += 0.5 * std::abs(cross(a, b));
        second += std::abs(cross(a, b)) * (a.dot(a) + a.dot(b) + b.dot(b)) / 12.0;
    }
    CHECK(relative(area, 12800.0) < 1e-14);
    CHECK(second / std::abs(moments_of_ring(k_dumbbell).second_moment) > 1.05);
}

TEST_CASE("the house's centroid lies at 190/3, not at the mean of its corners")
{
    // 100 x 100 below at 50, 50 x 50 of roof at 350/3: (10000 50 + 2500 350/3) / 12500
    const AreaMoments moments = moments_of_ring(k_house);
    CHECK(moments.area == 12500.0);
    CHECK(moments.centroid == Vec2(50.0, 190.0 / 3.0));
    double mean = 0.0;
    for (const Vec2& vertex : k_house) mean += vertex.y() / 5.0;
    CHECK(mean == doctest::Approx(70.0));
}

TEST_CASE("an L is the sum of its two rectangles by parallel axes")
{
    const Ring ring = {{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    const AreaMoments moments = moments_of_ring(ring);
    const Vec2 foot_centre(2.0, 0.5);
    const Vec2 stem_centre(0.5, 2.0);
    const MassProperties foot = rectangle_mass(4.0, 1.0, 1.0);
    const MassProperties stem = rectangle_mass(1.0, 2.0, 1.0);
    const Vec2 centre = (foot.mass * foot_centre + stem.mass * stem_centre) / (foot.mass + stem.mass);
    const double expected = about_parallel_axis(foot, (foot_centre - centre).norm()) +
                            about_parallel_axis(stem, (stem_centre - centre).norm());
    CHECK(moments.area == 6.0);
    CHECK((moments.centroid - centre).norm() < 4.0 * 0x1p-52);
    CHECK(relative(moments.second_moment, expected) < 8.0 * 0x1p-52);
}

TEST_CASE("a disc with a hole of many sides has the moments of an annulus")
{
    // Both rings lie inside their circles: the relative error of a 2^k-gon is (2/3)(pi/n)^2 of its area
    const int sides = 4096;
    const double inner = 0.5;
    const double outer = 1.5;
    std::vector<Ring> rings(2);
    for (int k = 0; k < sides; ++k) {
        const SineCosine sc = sine_cosine(2.0 * std::numbers::pi * k / sides);
        rings[0].push_back(outer * Vec2(sc.cosine, sc.sine));
        rings[1].push_back(inner * Vec2(sc.cosine, -sc.sine));
    }
    const MassProperties found = polygon_mass(Polygon(rings), 2.0);
    const MassProperties round = annulus_mass(inner, outer, 2.0);
    const double step = std::numbers::pi / sides;
    CHECK(relative(found.mass, round.mass) < 4.0 / 3.0 * step * step);
    CHECK(relative(found.moment_of_inertia, round.moment_of_inertia) < 4.0 / 3.0 * step * step);

    // Against two regular polygons only rounding is left
    const MassProperties whole = regular_polygon_mass(sides, outer, 2.0);
    const MassProperties hole = regular_polygon_mass(sides, inner, 2.0);
    CHECK(relative(found.mass, whole.mass - hole.mass) < 1e-14);
    CHECK(relative(found.moment_of_inertia, whole.moment_of_inertia - hole.moment_of_inertia) < 1e-14);
}

TEST_CASE("random polygons with whole coordinates are within one unit in the last place of exact rationals")
{
    // Sums carry about 100 bits: what is left is the last rounding of each number, half an ulp
    Random random(42);
    double worst = 0.0;
    for (int k = 0; k < 1000; ++k) {
        const int corners = 3 + random.below(30);
        const Ring ring = random_star(random, corners, std::exp2(random.uniform(4.0, 20.0)));
        const oracle::Moments exact = oracle::moments_of_rings({ring});
        if (exact.area <= 0) continue;
        worst = std::max(worst, worst_error(moments_of_ring(ring), exact));
    }
    for (int k = 0; k < 100; ++k) {
        const Ring ring = random_comb(random, 2 + random.below(30), 1000);
        worst = std::max(worst, worst_error(moments_of_ring(ring), oracle::moments_of_rings({ring})));
    }
    CHECK(worst < 0.501);
}

TEST_CASE("polygons with fractions are within one unit in the last place too, and slivers")
{
    Random random(43);
    double worst = 0.0;
    for (int k = 0; k < 1000; ++k) {
        Ring ring = random_star(random, 3 + random.below(12), 1e6);
        const double thin = std::exp2(random.uniform(-30.0, 0.0));
        for (Vec2& vertex : ring) vertex = Vec2(vertex.x() / 1234567.0, thin * vertex.y() / 1234567.0);
        const oracle::Moments exact = oracle::moments_of_rings({ring});
        if (exact.area <= 0) continue;
        worst = std::max(worst, worst_error(moments_of_ring(ring), exact));
    }
    CHECK(worst < 0.501);
}

TEST_CASE("a shape moved by 1e8 has the same moments, to the bit")
{
    Random random(44);
    for (int k = 0; k < 500; ++k) {
        const Ring ring = random_star(random, 3 + random.below(30), 1000.0);
        const Vec2 offset{random.below(2) * 2e8 - 1e8, random.below(2) * 2e8 - 1e8};
        const AreaMoments here = moments_of_ring(ring);
        const AreaMoments there = moments_of_ring(moved(ring, offset));
        REQUIRE(there.area == here.area);
        REQUIRE(there.second_moment == here.second_moment);

        // Each centroid is rounded once
        const Vec2 apart = there.centroid - here.centroid - offset;
        REQUIRE(apart.cwiseAbs().maxCoeff() <= 0x1p-26);
    }
}

TEST_CASE("plain sums about a far origin lose what signed triangles about a vertex keep")
{
    double second = 0.0;
    double area = 0.0;
    Vec2 first(0.0, 0.0);
    const Ring ring = moved(k_house, Vec2(1e8, 1e8));
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2& a = ring[k];
        const Vec2& b = ring[(k + 1) % ring.size()];
        area += 0.5 * cross(a, b);
        first += cross(a, b) / 6.0 * (a + b);
        second += cross(a, b) * (a.dot(a) + a.dot(b) + b.dot(b)) / 12.0;
    }
    const double plain = second - first.squaredNorm() / area;
    const double expected = moments_of_ring(k_house).second_moment;
    CHECK(relative(plain, expected) > 0.1);
    CHECK(moments_of_ring(ring).second_moment == expected);
}

TEST_CASE("a ring the other way round counts negatively, about the same centroid")
{
    Ring ring = k_house;
    const AreaMoments there = moments_of_ring(ring);
    std::reverse(ring.begin(), ring.end());
    const AreaMoments back = moments_of_ring(ring);
    CHECK(back.area == -there.area);
    CHECK(back.second_moment == -there.second_moment);
    CHECK(back.centroid == there.centroid);
}

TEST_CASE("mirror images, quarter turns and another first vertex give the same bits")
{
    Random random(45);
    for (int k = 0; k < 500; ++k) {
        Ring ring = random_star(random, 3 + random.below(30), 1000.0);
        for (Vec2& vertex : ring) vertex /= 7.0;
        const AreaMoments plain = moments_of_ring(ring);

        Ring mirrored = ring;
        for (Vec2& vertex : mirrored) vertex.x() = -vertex.x();
        const AreaMoments mirror = moments_of_ring(mirrored);
        REQUIRE(mirror.area == -plain.area);
        REQUIRE(mirror.second_moment == -plain.second_moment);
        REQUIRE(mirror.centroid == Vec2(-plain.centroid.x(), plain.centroid.y()));

        Ring turned = ring;
        for (Vec2& vertex : turned) vertex = perp(vertex);
        const AreaMoments turn = moments_of_ring(turned);
        REQUIRE(turn.area == plain.area);
        REQUIRE(turn.second_moment == plain.second_moment);
        REQUIRE(turn.centroid == perp(plain.centroid));

        std::rotate(ring.begin(), ring.begin() + random.below(static_cast<int>(ring.size())), ring.end());
        const AreaMoments rotated = moments_of_ring(ring);
        REQUIRE(relative(rotated.area, plain.area) <= 0x1p-52);
        REQUIRE(relative(rotated.second_moment, plain.second_moment) <= 0x1p-52);
    }
}

TEST_CASE("lengths scale by powers of two, to the bit")
{
    Random random(46);
    for (int k = 0; k < 500; ++k) {
        Ring ring = random_star(random, 3 + random.below(30), 1000.0);
        const AreaMoments plain = moments_of_ring(ring);
        const double scale = std::exp2(random.below(401) - 200);
        for (Vec2& vertex : ring) vertex *= scale;
        const AreaMoments scaled = moments_of_ring(ring);
        REQUIRE(scaled.area == scale * scale * plain.area);
        REQUIRE(scaled.second_moment == scale * scale * scale * scale * plain.second_moment);
        REQUIRE(scaled.centroid == Vec2(scale * plain.centroid));
    }
}

TEST_CASE("a ring without area has its first vertex for a centroid, and no NaN")
{
    const Ring ring = {{1, 1}, {2, 2}, {3, 3}};
    const AreaMoments moments = moments_of_ring(ring);
    CHECK(moments.area == 0.0);
    CHECK(moments.second_moment == 0.0);
    CHECK(moments.centroid == Vec2(1.0, 1.0));
}

TEST_CASE("every shape is weighed by its own formula")
{
    CHECK(mass_of(Disc{2.0}, 3.0).mass == disc_mass(2.0, 3.0).mass);
    CHECK(mass_of(Disc{2.0}, 3.0).moment_of_inertia == disc_mass(2.0, 3.0).moment_of_inertia);
    const Polygon house({k_house});
    CHECK(mass_of(house, 2.0).mass == 25000.0);
    CHECK(mass_of(house, 2.0).moment_of_inertia == 2.0 * moments_of_ring(k_house).second_moment);
    CHECK(std::isinf(mass_of(HalfPlane{}, 1.0).mass));
    CHECK(std::isinf(mass_of(HalfPlane{}, 1.0).moment_of_inertia));
}
