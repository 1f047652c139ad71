#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "collide/manifold.hpp"
#include "collide/separation.hpp"
#include "geometry/convex_parts.hpp"
#include "geometry/straight_vertices.hpp"
#include "support/random_polygons.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

std::vector<Vec2> ring_of(const Polygon& polygon)
{
    return {polygon.vertices().begin(), polygon.vertices().end()};
}

/// Up to five more vertices on every side, at random places, in order.
std::vector<Vec2> with_more(const std::vector<Vec2>& corners, Random& random)
{
    std::vector<Vec2> ring;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec2& from = corners[k];
        const Vec2& to = corners[(k + 1) % corners.size()];
        ring.push_back(from);
        const int more = random.below(6);
        for (int j = 1; j <= more; ++j) ring.push_back(from + ((j + 0.5 * random.uniform()) / (more + 1)) * (to - from));
    }
    return ring;
}

Polygon regular(int count)
{
    std::vector<Vec2> ring;
    for (int k = 0; k < count; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / count;
        ring.push_back(Vec2(std::cos(angle), std::sin(angle)));
    }
    return Polygon({ring});
}

/// A side of the whole and a cut that follow each other round a part, and turn by less than a thousandth.
int mixed_lines(const Polygon& whole, const Polygon& part)
{
    const auto is_side = [&](const Edge& edge) {
        return std::any_of(whole.edges().begin(), whole.edges().end(), [&](const Edge& side) {
            return whole.vertices()[side.from] == part.vertices()[edge.from] &&
                   whole.vertices()[side.to] == part.vertices()[edge.to];
        });
    };
    int count = 0;
    for (const Edge& edge : part.edges()) {
        const Edge& next = part.edges()[edge.to];
        if (is_side(edge) != is_side(next) && (edge.normal - next.normal).norm() < 1e-3) ++count;
    }
    return count;
}

} // namespace

TEST_CASE("vertices in the middle of straight sides are left out, and the corners stay to the bit")
{
    Random random(611);
    for (int k = 0; k < 2000; ++k) {
        const Polygon whole = random_convex(random);
        const Vec2 offset{random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3)};
        std::vector<Vec2> corners;
        const double size = std::exp2(random.below(41) - 20);
        for (const Vec2& v : whole.vertices()) corners.push_back(size * (v + (k % 2 == 0 ? offset : Vec2(0.0, 0.0))));
        std::vector<Vec2> ring = with_more(corners, random);

        // Where the ring begins says nothing
        const auto places = static_cast<int>(ring.size());
        std::rotate(ring.begin(), ring.begin() + random.below(places), ring.end());
        std::vector<Vec2> left = ring_of(without_straight_vertices(Polygon({ring})));
        REQUIRE(left.size() == corners.size());
        std::rotate(left.begin(), std::find(left.begin(), left.end(), corners[0]), left.end());
        CHECK(left == corners);
    }
}

TEST_CASE("what has corners only comes back as it is, however blunt they are")
{
    for (const int count : {3, 4, 5, 17, 360, 30000}) {
        const Polygon polygon = regular(count);
        CAPTURE(count);
        CHECK(ring_of(without_straight_vertices(polygon)) == ring_of(polygon));
    }

    // A roof over a side of two metres, from clearly a corner to rounding
    const auto roof = [](double height) {
        return Polygon({{Vec2(-1.0, -1.0), Vec2(1.0, -1.0), Vec2(1.0, 0.0), Vec2(0.0, height), Vec2(-1.0, 0.0)}});
    };
    CHECK(without_straight_vertices(roof(1e-3)).vertices().size() == 5);
    CHECK(without_straight_vertices(roof(1e-13)).vertices().size() == 5);
    CHECK(without_straight_vertices(roof(1e-15)).vertices().size() == 4);
    CHECK(without_straight_vertices(roof(0.0)).vertices().size() == 4);
    CHECK(without_straight_vertices(roof(-1e-15)).vertices().size() == 4);
}

TEST_CASE("a long row of blunt corners isn't straightened one by one")
{
    // Each corner alone is within rounding of the line between its neighbours; the arc that they make is not
    std::vector<Vec2> ring = {Vec2(0.0, -1.0), Vec2(1.0, -1.0)};
    const int count = 2000;
    for (int k = count; k >= 0; --k) {
        const double x = static_cast<double>(k) / count;
        ring.push_back(Vec2(x, 2e-9 * x * (1.0 - x)));
    }
    const Polygon left = without_straight_vertices(Polygon({ring}));
    CHECK(left.vertices().size() < ring.size());
    for (const Vec2& v : ring) {
        double outside = -1.0;
        for (const Edge& edge : left.edges()) outside = std::max(outside, edge.normal.dot(v - left.vertices()[edge.from]));
        CHECK(outside <= 1e-14);
    }
}

TEST_CASE("no part of a polygon has a side and a cut in one line")
{
    const Polygon plus({{Vec2(-3, -1), Vec2(-1, -1), Vec2(-1, -3), Vec2(1, -3), Vec2(1, -1), Vec2(3, -1), Vec2(3, 1),
                         Vec2(1, 1), Vec2(1, 3), Vec2(-1, 3), Vec2(-1, 1), Vec2(-3, 1)}});
    const Polygon t({{Vec2(-1, -3), Vec2(1, -3), Vec2(1, 0), Vec2(3, 0), Vec2(3, 2), Vec2(-3, 2), Vec2(-3, 0), Vec2(-1, 0)}});
    CHECK(convex_parts(plus).size() == 5);
    for (const Polygon& whole : {plus, t}) {
        for (const Polygon& part : convex_parts(whole)) CHECK(mixed_lines(whole, part) == 0);
    }

    Random random(612);
    for (int k = 0; k < 1000; ++k) {
        // On a grid, where nearly all corners have others in line
        std::vector<Vec2> low;
        std::vector<Vec2> ring;
        for (int x = 0; x < 6; ++x) {
            const double height = 1.0 + random.below(3);
            const double depth = -1.0 - random.below(3);
            low.push_back(Vec2(x, depth));
            low.push_back(Vec2(x + 1, depth));
            ring.push_back(Vec2(x, height));
            ring.push_back(Vec2(x + 1, height));
        }
        std::reverse(ring.begin(), ring.end());
        ring.insert(ring.begin(), low.begin(), low.end());
        ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
        const Polygon whole({ring});
        double area = 0.0;
        for (const Polygon& part : convex_parts(whole)) {
            CHECK(mixed_lines(whole, part) == 0);
            area += area_of_polygon(part);
        }
        CHECK(area == area_of_polygon(whole));
    }
}

TEST_CASE("a corner deep in a side is seen wherever on the side it is, also beyond a vertex in the middle of the side")
{
    // The lines of both halves part the two equally well; clipped to one of them, the corner over the other was lost
    Random random(613);
    for (int k = 0; k < 2000; ++k) {
        const std::vector<Vec2> corners = {Vec2(-1.0, -1.0), Vec2(1.0, -1.0), Vec2(1.0, 0.0), Vec2(-1.0, 0.0)};
        const Shape table = Polygon({with_more(corners, random)});
        const Shape part = make_collision_shape(table).parts[0].shape;
        const Shape square = box(0.4, 0.4);
        const double tilt = random.uniform(0.1, 0.7);
        const double depth = random.uniform(0.001, 0.02);
        const double turn = random.uniform(-3.0, 3.0);
        const double place = random.uniform(-0.6, 0.6);
        const double reach = 0.2 * (std::cos(tilt) + std::sin(tilt));
        const Pose world = at(random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0), turn);
        const Pose above{world * Vec2(place, reach - depth), Rotation::of(turn + tilt)};
        const Manifold manifold = make_manifold(part, world, square, above, 0.0);
        CAPTURE(k);
        REQUIRE(manifold.count == 1);
        CHECK(std::abs(manifold.contacts[0].separation + depth) < 1e-14);
        CHECK(std::abs(separation(table, world, square, above) + depth) < 1e-14);
    }
}

TEST_CASE("the boundary leads straight along a side, over its vertices, and not along a cut or round a corner")
{
    // An L with vertices in the middle of its lower side; the cut from its notch runs to the opposite corner
    const Polygon l({{Vec2(0, 0), Vec2(0.3, 0), Vec2(1.1, 0), Vec2(2, 0), Vec2(2, 1), Vec2(1, 1), Vec2(1, 2), Vec2(0, 2)}});
    CHECK(has_straight_side(l, Vec2(0, 0), Vec2(2, 0)));
    CHECK(has_straight_side(l, Vec2(0.3, 0), Vec2(2, 0)));
    CHECK(has_straight_side(l, Vec2(2, 1), Vec2(1, 1)));
    CHECK(has_straight_side(l, Vec2(0, 2), Vec2(0, 0)));
    CHECK_FALSE(has_straight_side(l, Vec2(2, 0), Vec2(0, 0))); // against the turn
    CHECK_FALSE(has_straight_side(l, Vec2(0, 0), Vec2(2, 1)));
    CHECK_FALSE(has_straight_side(l, Vec2(1, 1), Vec2(0, 0)));
    CHECK_FALSE(has_straight_side(l, Vec2(0, 0), Vec2(1, 1)));
}
