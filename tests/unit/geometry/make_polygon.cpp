#include "geometry/make_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>
#include <doctest/doctest.h>

#include "geometry/moments.hpp"
#include "math/random.hpp"
#include "math/sine_cosine.hpp"

using namespace flying;

namespace {

using Ring = std::vector<Vec2>;

Ring square(const Vec2& low, double side)
{
    return {low, low + Vec2(side, 0), low + Vec2(side, side), low + Vec2(0, side)};
}

Ring reversed(Ring ring)
{
    std::reverse(ring.begin(), ring.end());
    return ring;
}

Faults faults_of(const Ring& outer, const std::vector<Ring>& holes = {})
{
    const Expected<CentredPolygon> made = make_polygon(outer, holes);
    return made ? Faults{} : made.faults();
}

/// The only fault stands at the place, and says the words.
void check_fault(const Faults& faults, const std::string& place, const std::string& words)
{
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].place == place);
    CAPTURE(faults[0].found);
    CHECK(faults[0].found.find(words) != std::string::npos);
    CHECK_FALSE(faults[0].expected.empty());
}

/// A star-shaped ring about the origin.
Ring random_star(Random& random, int count)
{
    Ring ring;
    for (int k = 0; k < count; ++k) {
        const double angle = 2.0 * std::numbers::pi * (k + random.uniform(0.1, 0.9)) / count;
        const double distance = random.uniform(0.2, 1.0);
        const SineCosine sc = sine_cosine(angle);
        ring.push_back(distance * Vec2(sc.cosine, sc.sine));
    }
    return ring;
}

} // namespace

TEST_CASE("a square given anywhere, either way round, becomes one about its middle")
{
    for (const Ring& ring : {square(Vec2(3, 4), 2), reversed(square(Vec2(3, 4), 2)), square(Vec2(1e8, -1e8), 2)}) {
        const Expected<CentredPolygon> made = make_polygon(ring);
        REQUIRE(made.has_value());
        const Polygon& polygon = made.value().polygon;
        CHECK(moments_of(polygon).area == 4.0);
        CHECK(moments_of(polygon).centroid == Vec2(0.0, 0.0));
        CHECK(polygon.is_convex());
        for (const Vec2& vertex : polygon.vertices()) CHECK(vertex.cwiseAbs() == Vec2(1.0, 1.0));
        CHECK(made.value().centroid == Vec2((ring[0] + ring[2]) / 2.0));
    }
}

TEST_CASE("the centroid comes to rest within a rounding or two of the origin, however far off the ring was given")
{
    // Each vertex is rounded twice on its way, by half an ulp of the size: their mean effect on the centroid stays
    // below one
    Random random(71);
    double worst_near = 0.0;
    double worst_far = 0.0;
    for (int k = 0; k < 1000; ++k) {
        Ring ring = random_star(random, 4 + random.below(20));
        const Expected<CentredPolygon> near = make_polygon(ring);
        REQUIRE(near.has_value());
        worst_near = std::max(worst_near, moments_of(near.value().polygon).centroid.norm());

        for (Vec2& vertex : ring) vertex += Vec2(1e8, 3e7);
        const Expected<CentredPolygon> far = make_polygon(ring);
        REQUIRE(far.has_value());
        worst_far = std::max(worst_far, moments_of(far.value().polygon).centroid.norm());
    }
    CHECK(worst_near < 0x1p-52);
    CHECK(worst_far < 0x1p-52);
}

TEST_CASE("mirror images and quarter turns and powers of two give the same bits")
{
    Random random(72);
    for (int k = 0; k < 300; ++k) {
        Ring ring = random_star(random, 4 + random.below(20));
        for (Vec2& vertex : ring) vertex += Vec2(3.0, -7.0);
        Ring turned = ring;
        for (Vec2& vertex : turned) vertex = perp(vertex);
        const double scale = std::exp2(random.below(201) - 100);
        Ring scaled = ring;
        for (Vec2& vertex : scaled) vertex *= scale;
        Ring mirrored = ring;
        for (Vec2& vertex : mirrored) vertex.x() = -vertex.x();
        std::reverse(mirrored.begin() + 1, mirrored.end());

        const Polygon plain = make_polygon(ring).value().polygon;
        const Polygon turn = make_polygon(turned).value().polygon;
        const Polygon large = make_polygon(scaled).value().polygon;
        const Polygon mirror = make_polygon(mirrored).value().polygon;
        const std::size_t count = plain.vertices().size();
        for (std::size_t v = 0; v < count; ++v) {
            const Vec2& vertex = plain.vertices()[v];
            REQUIRE(turn.vertices()[v] == perp(vertex));
            REQUIRE(large.vertices()[v] == Vec2(scale * vertex));
            REQUIRE(mirror.vertices()[(count - v) % count] == Vec2(-vertex.x(), vertex.y()));
        }
    }
}

TEST_CASE("vertices that repeat their neighbour are dropped, also across the end of the ring")
{
    const Ring ring = {{0, 0}, {0, 0}, {1, 0}, {1, 1e-14}, {1, 1}, {0, 1}, {0, 1}, {0, 1e-15}, {0, 0}};
    const Expected<CentredPolygon> made = make_polygon(ring);
    REQUIRE(made.has_value());
    CHECK(made.value().polygon.vertices().size() == 4);
}

TEST_CASE("vertices on one line with their neighbours, or nearly so, are welcome")
{
    Ring ring = {{0, 0}, {1, 0}, {2, 0}, {3, 1e-17}, {4, -1e-13}, {5, 0}, {5, 5}, {2.5, 5}, {0, 5}, {0, 2}};
    const Expected<CentredPolygon> made = make_polygon(ring);
    REQUIRE(made.has_value());
    CHECK(made.value().polygon.vertices().size() == ring.size());
}

TEST_CASE("slivers of aspect 1e8 are polygons")
{
    CHECK(faults_of({{0, 0}, {1, 0}, {1, 1e-8}, {0, 1e-8}}).empty());
    CHECK(faults_of({{0, 0}, {1e8, 0}, {1e8, 1}}).empty());
}

TEST_CASE("holes turn clockwise, whichever way they came")
{
    for (const Ring& hole : {square(Vec2(1, 1), 1), reversed(square(Vec2(1, 1), 1))}) {
        const Expected<CentredPolygon> made = make_polygon(reversed(square(Vec2(0, 0), 4)), std::vector<Ring>{hole});
        REQUIRE(made.has_value());
        const AreaMoments moments = moments_of(made.value().polygon);
        CHECK(moments.area == 15.0);
        CHECK(moments.centroid.norm() < 4.0 * 0x1p-52);

        // (16 x 2 - 1 x 1.5) / 15
        CHECK(made.value().centroid.x() == doctest::Approx(30.5 / 15.0).epsilon(1e-15));
        CHECK_FALSE(made.value().polygon.is_convex());
    }
}

TEST_CASE("numbers that are no coordinates are all refused at once, each at its place")
{
    const double nan = std::nan("");
    const double infinity = std::numeric_limits<double>::infinity();
    const Faults faults = faults_of({{nan, 0}, {1, infinity}, {1e300, 0}, {1e-300, 1}, {5e-324, 1}, {0, 1}},
                                    {{{0, 0}, {0, -infinity}, {1, 1}}});
    REQUIRE(faults.size() == 6);
    CHECK(faults[0].place == "vertices[0]");
    CHECK(faults[0].found == "(nan, 0)");
    CHECK(faults[0].expected == "finite coordinates");
    CHECK(faults[1].place == "vertices[1]");
    CHECK(faults[2].place == "vertices[2]");
    CHECK(faults[2].found == "(1e+300, 0)");
    CHECK(faults[3].place == "vertices[3]");
    CHECK(faults[4].place == "vertices[4]");
    CHECK(faults[5].place == "holes[0][1]");
}

TEST_CASE("a polygon too small for its fourth power is refused")
{
    check_fault(faults_of({{0, 0}, {1e-100, 0}, {0, 1e-100}}), "vertices", "a size of 1e-100");
    CHECK(faults_of({{0, 0}, {1e-70, 0}, {0, 1e-70}}).empty());
    CHECK(faults_of({{0, 0}, {1e70, 0}, {0, 1e70}}).empty());
}

TEST_CASE("fewer than three distinct vertices are no polygon")
{
    check_fault(faults_of({}), "vertices", "0 vertices");
    check_fault(faults_of({{1, 1}}), "vertices", "1 vertex");
    check_fault(faults_of({{1, 1}, {2, 2}}), "vertices", "2 vertices");
    check_fault(faults_of({{1, 1}, {2, 2}, {1, 1}, {1, 1}}), "vertices", "4 vertices, 2 of them distinct");
    check_fault(faults_of({{1, 1}, {1, 1}, {1, 1}}), "vertices", "3 vertices, 1 of them distinct");
    check_fault(faults_of(square(Vec2(0, 0), 4), {{}}), "holes[0]", "0 vertices");
}

TEST_CASE("vertices on one line have no area, and run back along it")
{
    const Faults faults = faults_of({{0, 0}, {1, 1}, {2, 2}});
    REQUIRE(faults.size() == 3);
    CHECK(faults[0].place == "vertices");
    CHECK(faults[0].found == "an area of 0 m^2");
    CHECK(faults[1].place == "vertices[0]");
    CHECK(faults[2].place == "vertices[1]");
}

TEST_CASE("crossing edges are both named, with their ends")
{
    const Faults faults = faults_of({{0, 0}, {4, 0}, {4, 4}, {1, -1}});
    check_fault(faults, "vertices[0]",
                "edge 0 of vertices, from (0, 0) to (4, 0) crosses edge 2 of vertices, from (4, 4) to (1, -1)");
    CHECK(faults[0].expected == "edges that do not cross or touch");
}

TEST_CASE("edges keep the numbers that they were given, though vertices before them were dropped")
{
    check_fault(faults_of({{0, 0}, {0, 0}, {4, 0}, {4, 0}, {4, 4}, {1, -1}}), "vertices[0]",
                "crosses edge 4 of vertices");
}

TEST_CASE("a bow tie of no area is told both faults")
{
    const Faults faults = faults_of({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
    REQUIRE(faults.size() == 2);
    CHECK(faults[0].found == "an area of 0 m^2");
    CHECK(faults[1].found.find("crosses") != std::string::npos);
}

TEST_CASE("spikes, rings that touch themselves and rings that pass a point twice are refused")
{
    const Faults spike = faults_of({{0, 0}, {2, 0}, {4, 0}, {2, 0}, {2, 2}});
    REQUIRE_FALSE(spike.empty());
    CHECK(spike[0].place == "vertices[0]");
    CHECK(spike[0].found.find("touches") != std::string::npos);

    const Faults vertex_on_edge = faults_of({{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 2}, {1, 0}, {0, 4}});
    REQUIRE_FALSE(vertex_on_edge.empty());
    CHECK(vertex_on_edge[0].place == "vertices[0]");
    CHECK(vertex_on_edge[0].found.find("touches edge 4") != std::string::npos);

    // A corner visited twice, and an edge that runs along another
    CHECK_FALSE(faults_of({{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}).empty());
    CHECK_FALSE(faults_of({{0, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 0}, {1, 0}, {1, 2}, {0, 2}}).empty());
}

TEST_CASE("a vertex that misses an edge by the least possible is a polygon only if it still does about the centroid")
{
    // Exact decisions on what was given and on what comes out; never a polygon that touches itself
    Random random(73);
    int accepted = 0;
    for (int k = 0; k < 300; ++k) {
        const double gap = std::exp2(random.uniform(-60.0, -45.0));
        const double tip = 1.0 + gap;
        const Ring ring = {{0, 1}, {3, 1}, {3, 3}, {1.5 + random.uniform(-0.3, 0.3), tip}, {0.5, 3}, {0, 3}};
        const Expected<CentredPolygon> made = make_polygon(ring);
        if (!made) continue;
        ++accepted;
        const std::span<const Vec2> vertices = made.value().polygon.vertices();
        REQUIRE(vertices[3].y() > vertices[0].y());
    }
    CHECK(accepted > 0);
}

TEST_CASE("holes that cross, touch, lie outside or within each other are refused")
{
    const Ring outer = square(Vec2(0, 0), 10);
    CHECK(faults_of(outer, {square(Vec2(1, 1), 2), square(Vec2(4, 4), 2)}).empty());

    const Faults crossing = faults_of(outer, {square(Vec2(9, 1), 2)});
    REQUIRE(crossing.size() >= 1);
    CHECK(crossing[0].place == "vertices[1]");
    CHECK(crossing[0].found.find("crosses edge 0 of holes[0]") != std::string::npos);

    CHECK_FALSE(faults_of(outer, {square(Vec2(8, 1), 2)}).empty());                        // along the rim
    CHECK_FALSE(faults_of(outer, {square(Vec2(1, 1), 2), square(Vec2(3, 3), 2)}).empty()); // corner on corner
    check_fault(faults_of(outer, {square(Vec2(20, 1), 2)}), "holes[0]", "a hole outside vertices");
    check_fault(faults_of(outer, {square(Vec2(1, 1), 5), square(Vec2(2, 2), 1)}), "holes[1]", "a hole inside holes[0]");
    check_fault(faults_of(outer, {square(Vec2(2, 2), 1), square(Vec2(1, 1), 5)}), "holes[0]", "a hole inside holes[1]");
    CHECK(faults_of(outer, {square(Vec2(-1, -1), 12)}).size() == 1); // about the whole
}

TEST_CASE("faults of many kinds come back together")
{
    const Faults faults = faults_of({{0, 0}, {4, 0}, {4, 4}, {1, -1}}, {{{1, 1}}, square(Vec2(50, 0), 1)});
    std::vector<std::string> places;
    for (const Fault& fault : faults) places.push_back(fault.place);
    CHECK(places == std::vector<std::string>{"holes[0]", "vertices[0]"});

    const Faults others = faults_of(square(Vec2(0, 0), 10), {{{1, 1}}, square(Vec2(50, 0), 1), square(Vec2(9, 9), 3)});
    CHECK(others.front().place == "holes[0]");
    CHECK(others.back().place == "holes[1]");
    CHECK(others.size() == 4);
}

TEST_CASE("random rings are judged simple or not as a plain comparison of all pairs in exact rationals judges them")
{
    // Whole coordinates in a small box, so that touching and running along one another is common
    using Rational = boost::multiprecision::cpp_rational;
    const auto turn = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        const Rational d = (Rational(b.x()) - Rational(a.x())) * (Rational(c.y()) - Rational(a.y())) -
                           (Rational(b.y()) - Rational(a.y())) * (Rational(c.x()) - Rational(a.x()));
        return (d > 0 ? 1 : 0) - (d < 0 ? 1 : 0);
    };
    const auto on_segment = [&](const Vec2& p, const Vec2& a, const Vec2& b) {
        return turn(a, b, p) == 0 && (p - a).dot(p - b) <= 0.0;
    };
    const auto meet = [&](const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
        if (on_segment(a, c, d) || on_segment(b, c, d) || on_segment(c, a, b) || on_segment(d, a, b)) return true;
        return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
    };
    Random random(74);
    int simple_rings = 0;
    for (int k = 0; k < 4000; ++k) {
        Ring ring;
        const int count = 3 + random.below(5);
        const int box = 2 + random.below(8);
        for (int v = 0; v < count; ++v) ring.push_back(Vec2{random.below(box), random.below(box)});
        bool simple = true;
        for (int i = 0; i < count && simple; ++i) {
            const Vec2& a = ring[i];
            const Vec2& b = ring[(i + 1) % count];
            if (a == b) simple = false; // repeated neighbours are another case
            for (int j = 0; j < count; ++j) {
                const Vec2& c = ring[j];
                const Vec2& d = ring[(j + 1) % count];
                if (j == i) continue;
                const bool next = j == (i + 1) % count;
                const bool before = i == (j + 1) % count;
                if (next && on_segment(d, a, b)) simple = false;
                if (next && on_segment(a, c, d)) simple = false;
                if (!next && !before && meet(a, b, c, d)) simple = false;
            }
        }
        bool repeats = false;
        for (int i = 0; i < count; ++i) repeats = repeats || ring[i] == ring[(i + 1) % count];
        if (repeats) continue;
        CAPTURE(k);
        REQUIRE(make_polygon(ring).has_value() == simple);
        simple_rings += simple ? 1 : 0;
    }
    CHECK(simple_rings > 100);
}

TEST_CASE("a hundred thousand sides are checked in a moment")
{
    Ring ring;
    const int count = 100000;
    for (int k = 0; k < count; ++k) {
        const SineCosine sc = sine_cosine(2.0 * std::numbers::pi * k / count);
        ring.push_back(Vec2(sc.cosine, sc.sine));
    }
    CHECK(faults_of(ring).empty());
}
