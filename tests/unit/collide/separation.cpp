#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "collide/separation.hpp"
#include "math/tolerance.hpp"
#include "support/random_polygons.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// A square frame: outside 4, the hole 2.
Polygon frame()
{
    return Polygon(
        {{Vec2(-2, -2), Vec2(2, -2), Vec2(2, 2), Vec2(-2, 2)}, {Vec2(-1, -1), Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1)}});
}

/// A U with walls of 1 round a channel of width 2, open above.
Polygon channel()
{
    return Polygon(
        {{Vec2(-2, -1), Vec2(2, -1), Vec2(2, 3), Vec2(1, 3), Vec2(1, 0), Vec2(-1, 0), Vec2(-1, 3), Vec2(-2, 3)}});
}

Shape random_shape(Random& random)
{
    switch (random.below(4)) {
    case 0:
        return Disc{random.uniform(0.05, 1.0)};
    case 1:
        return random_convex(random);
    case 2:
        return random_star(random, false);
    default:
        return random_star(random, true);
    }
}

Shape scaled(const Shape& shape, double factor)
{
    if (const auto* disc = std::get_if<Disc>(&shape)) return Disc{disc->radius * factor};
    const Polygon& polygon = std::get<Polygon>(shape);
    std::vector<std::vector<Vec2>> rings;
    for (int k = 0; k + 1 < static_cast<int>(polygon.ring_starts().size()); ++k) {
        rings.push_back(placed_ring(polygon, Pose(), k));
        for (Vec2& vertex : rings.back()) vertex *= factor;
    }
    return Polygon(rings);
}

/// Roundings of a distance of bodies a few metres in size and apart.
constexpr double k_gap_bound = 20.0 * 8.0 * tolerance::k_epsilon;

} // namespace

TEST_CASE("discs, half-planes and polygons are separated by elementary distances")
{
    CHECK(separation(Disc{1.0}, at(0, 0), Disc{2.0}, at(6, 8)) == 7.0);
    CHECK(separation(Disc{1.0}, at(0, 0), Disc{2.0}, at(0, 0)) == -3.0);
    const HalfPlane ground{Vec2(0.0, 1.0), 1.0};
    CHECK(separation(ground, Pose(), Disc{2.0}, at(5, 4)) == 1.0);
    CHECK(separation(Disc{2.0}, at(5, 0), ground, Pose()) == -3.0);
    CHECK(separation(ground, Pose(), box(2, 2), at(7, 2.5)) == 0.5);
    CHECK(separation(channel(), at(0, 1), ground, Pose()) == -1.0);
    CHECK(separation(ground, Pose(), ground, Pose()) == std::numeric_limits<double>::infinity());

    // A disc off a side, off a corner, and with its centre inside
    CHECK(separation(box(2, 2), at(0, 0), Disc{0.5}, at(3, 0)) == 1.5);
    CHECK(separation(box(2, 2), at(0, 0), Disc{0.5}, at(4, 5)) == 4.5);
    CHECK(separation(Disc{0.5}, at(0.75, 0), box(2, 2), at(0, 0)) == -0.75);
    // Corner to corner, where no edge's normal gives the distance
    CHECK(separation(box(2, 2), at(0, 0), box(2, 2), at(5, 6)) == 5.0);
}

TEST_CASE("a hole holds a body without overlap, and a body in the solid part overlaps")
{
    CHECK(separation(frame(), at(0, 0), Disc{0.25}, at(0, 0)) == 0.75);
    CHECK(separation(frame(), at(0, 0), box(1, 1), at(0.25, 0)) == 0.25);
    CHECK(separation(frame(), at(0, 0), box(2, 2), at(0, 0)) == 0.0);
    CHECK(separation(frame(), at(0, 0), box(0.5, 0.5), at(1.5, 0)) < -0.2);
    // One frame in the hole of a larger one
    const Shape small = scaled(frame(), 0.25);
    CHECK(separation(frame(), at(0, 0), small, at(0, 0)) == 0.5);
    CHECK(separation(small, at(0.25, 0.25), frame(), at(0, 0)) == 0.25);
}

TEST_CASE("a channel lets a bar in as far as there is room")
{
    const Shape bar = box(1, 4);
    CHECK(separation(channel(), at(0, 0), bar, at(0, 2.5)) == 0.5);
    CHECK(separation(channel(), at(0, 0), bar, at(0, 2.25)) == 0.25);
    CHECK(separation(channel(), at(0, 0), bar, at(0, 2)) == 0.0);
    // The bar in the floor by 0.25: the floor's part gives the depth
    CHECK(separation(channel(), at(0, 0), bar, at(0, 1.75)) == -0.25);
    CHECK(separation(channel(), at(0, 0), bar, at(0.75, 3)) == -0.25);
}

TEST_CASE("a body within another overlaps, however small it is")
{
    for (const double size : {1.0, 1e-3, 1e-9}) {
        // The way out leads over the nearer side: half of 4, and all of the body's own half
        const double depth = separation(box(4, 4), at(0, 0), box(size, size), at(0, 0));
        CHECK(depth == doctest::Approx(-2.0 - 0.5 * size).epsilon(1e-15));
        CHECK(separation(box(4, 4), at(0, 0), Disc{0.5 * size}, at(0, 1)) == doctest::Approx(-1.0 - 0.5 * size));
    }
}

TEST_CASE("random polygons, with holes or not, are as far apart as their boundaries, and overlap where interiors meet")
{
    Random random(611);
    int apart = 0;
    int crossing = 0;
    int held = 0;
    for (int k = 0; k < 6000; ++k) {
        const Polygon a = random_star(random, k % 2 == 0);
        const Polygon b = k % 3 == 0 ? random_star(random, k % 4 == 0) : random_convex(random);
        const double size = k % 5 == 0 ? 0.05 : 1.0;
        const Polygon small = std::get<Polygon>(scaled(Shape(b), size));
        const Pose pose_a = random_pose(random, k % 5 == 0 ? 0.1 : 1.5);
        const Pose pose_b = random_pose(random, k % 5 == 0 ? 0.1 : 1.5);
        const double gap = separation(Shape(a), pose_a, Shape(small), pose_b);

        const bool is_held =
            contains(a, pose_a, pose_b * small.vertices()[0]) || contains(small, pose_b, pose_a * a.vertices()[0]);
        if (boundaries_cross(a, pose_a, small, pose_b)) {
            ++crossing;
            CHECK(gap < 0.0);
        } else if (is_held) {
            ++held;
            CHECK(gap < 0.0);
        } else {
            ++apart;
            CHECK(std::abs(gap - boundary_distance(a, pose_a, small, pose_b)) <= k_gap_bound);
        }
        // Pushed apart by less than the depth, the two still overlap somewhere; by their widths, they never do
        CHECK(gap > -3.0 * (a.radius() + small.radius()));
    }
    CHECK(apart > 500);
    CHECK(crossing > 500);
    CHECK(held > 50);
}

TEST_CASE("the depth of concave shapes is no more than any push that parts them")
{
    Random random(612);
    for (int k = 0; k < 1500; ++k) {
        const Shape a = random_star(random, k % 2 == 0);
        const Shape b = random_star(random, false);
        const CollisionShape parts_a = make_collision_shape(a);
        const CollisionShape parts_b = make_collision_shape(b);
        const Pose pose_a = random_pose(random, 0.8);
        const Pose pose_b = random_pose(random, 0.8);
        const double depth = -separation(parts_a, pose_a, parts_b, pose_b);
        if (depth <= 0.0) continue;
        for (int i = 0; i < 40; ++i) {
            const Rotation way = Rotation::of(0.05 * 3.15 * i);
            const double push = depth * (1.0 - 1e-9);
            const Pose pushed = {pose_b.position + push * Vec2(way.cosine, way.sine), pose_b.rotation};
            CHECK(separation(parts_a, pose_a, parts_b, pushed) < 0.0);
        }
    }
}

TEST_CASE("shapes placed in contact are apart by rounding, and never deep in each other")
{
    Random random(613);
    for (int k = 0; k < 5000; ++k) {
        // Put the tip of a thin triangle onto a place of a random edge, from outside, turned at random
        const Polygon a = random_star(random, k % 2 == 0);
        const Pose pose_a = random_pose(random, 3.0);
        const Edge& edge = a.edges()[random.below(static_cast<int>(a.edges().size()))];
        const double along = random.below(4) == 0 ? 0.5 : random.uniform(0.05, 0.95);
        const Vec2 target = pose_a * Vec2(a.vertices()[edge.from] + along * edge.length * edge.tangent);
        const double size = 1e-5;
        const Polygon tip({{Vec2(0, 0), Vec2(size, -0.1 * size), Vec2(size, 0.1 * size)}});
        const double lean = random.uniform(-1.2, 1.2);
        const double angle = std::atan2(edge.normal.y(), edge.normal.x()) + lean;
        const Pose pose_b = {target, pose_a.rotation * Rotation::of(angle)};
        const double gap = separation(Shape(a), pose_a, Shape(tip), pose_b);
        CHECK(std::abs(gap) <= 2e-15);
    }
}

TEST_CASE("boxes side by side, corner to corner and end to end touch with no gap beyond rounding, at any angle")
{
    Random random(614);
    for (int k = 0; k < 3000; ++k) {
        const double w = random.uniform(0.1, 2.0);
        const double h = random.uniform(0.1, 2.0);
        const double angle = random.uniform(-3.0, 3.0);
        const Pose a = {Vec2{random.uniform(-9.0, 9.0), random.uniform(-9.0, 9.0)}, Rotation::of(angle)};
        const double slide = random.uniform(-h, h);
        for (const Vec2& offset : {Vec2(w, slide), Vec2(w, h), Vec2(w, 0.0)}) {
            const Pose b = {a * offset, a.rotation};
            CHECK(std::abs(separation(box(w, h), a, box(w, h), b)) <= 1e-14);
        }
    }
}

TEST_CASE("slivers end to end are as far apart as their ends, and crossed slivers overlap by their width")
{
    const Shape sliver = box(1.0, 1e-8);
    CHECK(separation(sliver, at(0, 0, 0.3), sliver, at(1.25 * std::cos(0.3), 1.25 * std::sin(0.3), 0.3)) ==
          doctest::Approx(0.25).epsilon(1e-12));
    CHECK(separation(sliver, at(0, 0), sliver, at(0, 0.25)) == doctest::Approx(0.25));
    const double crossed = separation(sliver, at(0, 0, 0.3), sliver, at(0, 0, 1.3));
    CHECK(crossed < -0.4);

    // Triangles of next to no area, tip to tip on one line
    const Shape needle = Polygon({{Vec2(-1, 0), Vec2(1, 0), Vec2(0, 1e-17)}});
    CHECK(separation(needle, at(0, 0), needle, at(2.5, 0)) == doctest::Approx(0.5));
    // Crossed, each could leave over the other's nearer end; the shorter way is along the leaning one's normal, where
    // the lying one reaches sin 1 to either side of its middle, and the leaning one stands at 0.1 cos 1 - 0.5 sin 1
    const double depth = 0.5 * std::sin(1.0) + 0.1 * std::cos(1.0);
    CHECK(separation(needle, at(0, 0), needle, at(0.5, 0.1, 1.0)) == doctest::Approx(-depth).epsilon(1e-12));
}

TEST_CASE("separation is the same from either side, and after any common motion, to rounding")
{
    Random random(615);
    for (int k = 0; k < 3000; ++k) {
        const Shape a = random_shape(random);
        const Shape b = random_shape(random);
        const Pose pose_a = random_pose(random, 1.5);
        const Pose pose_b = random_pose(random, 1.5);
        const double gap = separation(a, pose_a, b, pose_b);
        CHECK(std::abs(separation(b, pose_b, a, pose_a) - gap) <= k_gap_bound);

        const Pose motion = random_pose(random, 5.0);
        const Pose moved_a = {motion * pose_a.position, motion.rotation * pose_a.rotation};
        const Pose moved_b = {motion * pose_b.position, motion.rotation * pose_b.rotation};
        CHECK(std::abs(separation(a, moved_a, b, moved_b) - gap) <= 2.0 * k_gap_bound);
    }
}

TEST_CASE("far from the origin, the gap is as exact as the positions are")
{
    // 2^40 + 1.5 is a double: the difference of the positions is exact
    const Pose near = at(0, 0, 0.0);
    const Pose other = at(1.5, 0.0, 0.0);
    const Pose far = at(0x1p40, -0x1p40);
    const Pose far_other = at(0x1p40 + 1.5, -0x1p40);
    const double gap = separation(channel(), near, box(1, 2), other);
    CHECK(separation(channel(), far, box(1, 2), far_other) == gap);
    CHECK(separation(Disc{0.5}, far, Disc{0.5}, far_other) == 0.5);
}

TEST_CASE("scaling all lengths by a power of two scales the separation bit for bit")
{
    Random random(616);
    for (int k = 0; k < 2000; ++k) {
        const Shape a = random_shape(random);
        const Shape b = random_shape(random);
        const Pose pose_a = random_pose(random, 1.5);
        const Pose pose_b = random_pose(random, 1.5);
        const double gap = separation(a, pose_a, b, pose_b);
        for (const double factor : {0x1p100, 0x1p-100, 0x1p-3}) {
            const Pose far_a = {factor * pose_a.position, pose_a.rotation};
            const Pose far_b = {factor * pose_b.position, pose_b.rotation};
            CHECK(separation(scaled(a, factor), far_a, scaled(b, factor), far_b) == factor * gap);
        }
    }
}

TEST_CASE("polygons with many sides are as far apart as trying every vertex says, and as discs to the size of a side")
{
    Random random(617);
    for (int k = 0; k < 200; ++k) {
        const Polygon a = random_convex(random, 200);
        const Polygon b = random_convex(random, 200);
        const Pose pose_a = random_pose(random, 4.0);
        const Pose pose_b = random_pose(random, 4.0);
        const double gap = separation(Shape(a), pose_a, Shape(b), pose_b);
        if (gap > 0.0) CHECK(std::abs(gap - boundary_distance(a, pose_a, b, pose_b)) <= k_gap_bound);
        if (gap <= 0.0) CHECK(std::abs(gap - minkowski_separation(a, pose_a, b, pose_b)) <= k_gap_bound);
    }

    const int sides = 100000;
    std::vector<Vec2> ring;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / sides;
        ring.push_back(Vec2(std::cos(angle), std::sin(angle)));
    }
    const CollisionShape round = make_collision_shape(Polygon({ring}));
    const double sagitta = 2.0 * (1.0 - std::cos(std::numbers::pi / sides));
    for (const double distance : {1.9, 2.0 - 1e-6, 2.0 + 1e-6, 3.0, 10.0}) {
        const double gap = separation(round, at(0, 0, 0.1), round, at(distance, 0, 0.7));
        CHECK(std::abs(gap - (distance - 2.0)) <= sagitta + 1e-14);
    }
}
