#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "collide/manifold.hpp"
#include "collide/separating_axis.hpp"
#include "collide/separation.hpp"
#include "math/tolerance.hpp"
#include "support/random_polygons.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Roundings of a separation of bodies a few metres in size and apart: some twenty operations on numbers below 8.
constexpr double k_bound = 20.0 * 8.0 * tolerance::k_epsilon;

} // namespace

TEST_CASE("two boxes at any angle are separated by what their half extents leave of the distance of their centres")
{
    Random random(501);
    for (int k = 0; k < 20000; ++k) {
        const double w[2] = {random.uniform(0.1, 3.0), random.uniform(0.1, 3.0)};
        const double h[2] = {random.uniform(0.1, 3.0), random.uniform(0.1, 3.0)};
        const double angle_a = random.uniform(-3.0, 3.0);
        const double angle_b = random.uniform(-3.0, 3.0);
        const Pose a = {Vec2{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)}, Rotation::of(angle_a)};
        const Pose b = {Vec2{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)}, Rotation::of(angle_b)};

        // Along its own axis a box reaches w / 2, along another one |cos| w / 2 + |sin| h / 2
        const Vec2 d = b.position - a.position;
        const double c = std::abs(std::cos(angle_b - angle_a));
        const double s = std::abs(std::sin(angle_b - angle_a));
        double expected = -1e300;
        for (int i = 0; i < 2; ++i) {
            const double angle = i == 0 ? angle_a : angle_b;
            const int j = 1 - i;
            const Vec2 along(std::cos(angle), std::sin(angle));
            const double x_gap = std::abs(d.dot(along)) - 0.5 * (w[i] + c * w[j] + s * h[j]);
            const double y_gap = std::abs(d.dot(perp(along))) - 0.5 * (h[i] + s * w[j] + c * h[j]);
            expected = std::max({expected, x_gap, y_gap});
        }
        const Axis axis = greatest_separation(box(w[0], h[0]), box(w[1], h[1]), relative_pose(a, b));
        CHECK(std::abs(axis.separation - expected) <= k_bound);
    }
}

TEST_CASE("the separation of convex polygons is the distance of the origin from their Minkowski difference")
{
    Random random(502);
    int overlapping = 0;
    for (int k = 0; k < 20000; ++k) {
        const Polygon a = random_convex(random);
        const Polygon b = random_convex(random);
        const Pose pose_a = random_pose(random, 1.5);
        const Pose pose_b = random_pose(random, 1.5);
        const double expected = minkowski_separation(a, pose_a, b, pose_b);
        overlapping += expected < 0.0 ? 1 : 0;
        CHECK(std::abs(separation(Shape(a), pose_a, Shape(b), pose_b) - expected) <= k_bound);
    }
    CHECK(overlapping > 5000);
    CHECK(overlapping < 15000);
}

TEST_CASE("walking round both polygons finds the same axis as trying every vertex for every edge")
{
    Random random(503);
    for (int k = 0; k < 3000; ++k) {
        const int sides = k % 10 == 0 ? 400 : 12;
        const Polygon a = random_convex(random, sides);
        const Polygon b = random_convex(random, sides);
        const Pose a_from_b = random_pose(random, 2.0);
        const Pose b_from_a = relative_pose(a_from_b, Pose());
        double plain = -1e300;
        for (int e = 0; e < static_cast<int>(a.edges().size()); ++e) {
            plain = std::max(plain, axis_of_edge(a, e, b, a_from_b).separation);
        }
        for (int e = 0; e < static_cast<int>(b.edges().size()); ++e) {
            plain = std::max(plain, axis_of_edge(b, e, a, b_from_a).separation);
        }
        CHECK(std::abs(greatest_separation(a, b, a_from_b).separation - plain) <= k_bound);
    }
}

TEST_CASE("two crossing bars overlap, though no corner of one lies in the other's bounding box of corners")
{
    const Shape lying = box(4.0, 0.5);
    const Shape standing = box(0.5, 4.0);
    // The shortest push moves one bar out along its own length's normal: half of 4 and half of 0.5
    CHECK(separation(lying, at(0.0, 0.0), standing, at(0.0, 0.0)) == doctest::Approx(-2.25).epsilon(1e-15));
    // One bar through the other's end
    CHECK(separation(lying, at(0.0, 0.0), standing, at(1.9, 0.0)) == doctest::Approx(-0.35).epsilon(1e-14));
}

TEST_CASE("two squares that meet head on touch along their facing sides and nowhere else")
{
    const Shape square = box(1.0, 1.0);
    for (const double overlap : {0.25, 1e-6, 0.0}) {
        const Manifold manifold = make_manifold(square, at(0.0, 0.0), square, at(1.0 - overlap, 0.0), 0.0);
        REQUIRE(manifold.count == 2);
        for (const Contact& contact : manifold.contacts) {
            CHECK(contact.normal == Vec2(1.0, 0.0));
            CHECK(contact.separation == doctest::Approx(-overlap).epsilon(1e-9));
            CHECK(contact.point.x() == doctest::Approx(0.5 - 0.5 * overlap));
            CHECK(std::abs(contact.point.y()) == 0.5);
        }
        CHECK(manifold.contacts[0].point.y() == -manifold.contacts[1].point.y());
    }
}

TEST_CASE("a box on a longer one stands on its own two corners, and past an end on the end")
{
    const Shape floor = box(10.0, 1.0);
    const Shape crate = box(1.0, 1.0);
    const Manifold inside = make_manifold(floor, at(0.0, 0.0), crate, at(2.0, 0.9), 0.0);
    REQUIRE(inside.count == 2);
    CHECK(std::min(inside.contacts[0].point.x(), inside.contacts[1].point.x()) == doctest::Approx(1.5));
    CHECK(std::max(inside.contacts[0].point.x(), inside.contacts[1].point.x()) == doctest::Approx(2.5));

    const Manifold past = make_manifold(floor, at(0.0, 0.0), crate, at(5.0, 0.9), 0.0);
    REQUIRE(past.count == 2);
    CHECK(std::min(past.contacts[0].point.x(), past.contacts[1].point.x()) == doctest::Approx(4.5));
    CHECK(std::max(past.contacts[0].point.x(), past.contacts[1].point.x()) == doctest::Approx(5.0));
    for (const Contact& contact : past.contacts) {
        CHECK(contact.normal.isApprox(Vec2(0.0, 1.0), 1e-15));
        CHECK(contact.separation == doctest::Approx(-0.1));
        CHECK(contact.point.y() == doctest::Approx(0.45));
    }
}

TEST_CASE("a box that leans a little, either way, rests on the two corners of the side that faces the ground")
{
    const HalfPlane ground{Vec2(0.0, 1.0), 0.5};
    const Shape floor = box(10.0, 1.0);
    const Shape crate = box(1.0, 1.0);
    for (const double tilt : {0.01, -0.01}) {
        // The corners at (+-0.5, -0.5) stand at heights 0.95 -+ sin / 2 - cos / 2
        const double low = 0.95 - 0.5 * std::sin(0.01) - 0.5 * std::cos(0.01) - 0.5;
        const double high = 0.95 + 0.5 * std::sin(0.01) - 0.5 * std::cos(0.01) - 0.5;
        for (const Manifold& manifold : {make_manifold(floor, at(0.0, 0.0), crate, at(2.0, 0.95, tilt), 0.0),
                                         make_manifold(ground, Pose(), crate, at(2.0, 0.95, tilt), 0.0)}) {
            REQUIRE(manifold.count == 2);
            const Contact* left = &manifold.contacts[0];
            const Contact* right = &manifold.contacts[1];
            if (left->point.x() > right->point.x()) std::swap(left, right);
            CHECK(left->separation == doctest::Approx(tilt > 0.0 ? low : high));
            CHECK(right->separation == doctest::Approx(tilt > 0.0 ? high : low));
            CHECK(right->point.x() - left->point.x() == doctest::Approx(std::cos(0.01)));
        }
    }
}

TEST_CASE("a feature keeps its number while the bodies move a little, and different features differ")
{
    const Shape floor = box(10.0, 1.0);
    const Shape crate = box(1.0, 1.0);
    const Manifold first = make_manifold(floor, at(0.0, 0.0), crate, at(2.0, 0.99), 0.0);
    const Manifold moved = make_manifold(floor, at(0.0, 0.0), crate, at(2.1, 0.985, 0.001), 0.0);
    REQUIRE(first.count == 2);
    REQUIRE(moved.count == 2);
    CHECK(first.contacts[0].feature != first.contacts[1].feature);
    for (int k = 0; k < 2; ++k) CHECK(first.contacts[k].feature == moved.contacts[k].feature);
}

TEST_CASE("two contacts of a manifold have two names, whichever comes first, and a disc's one contact is renamed with "
          "its owners")
{
    Random random(505);
    int pairs = 0;
    for (int k = 0; k < 200000; ++k) {
        // Few corners, so that corner 0 on edge 0 is not rare
        const Shape a = random_convex(random, 4);
        const Shape b = random_convex(random, 4);
        const double angle_a = random.uniform(-3.0, 3.0);
        const double angle_b = random.uniform(-3.0, 3.0);
        const double x = random.uniform(-2.0, 2.0);
        const double y = random.uniform(-2.0, 2.0);
        const Pose pose_a = {Vec2::Zero(), Rotation::of(angle_a)};
        const Pose pose_b = {Vec2(x, y), Rotation::of(angle_b)};
        for (const bool swapped : {false, true}) {
            const Manifold manifold =
                swapped ? make_manifold(b, pose_b, a, pose_a, 0.1) : make_manifold(a, pose_a, b, pose_b, 0.1);
            if (manifold.count < 2) continue;
            ++pairs;
            REQUIRE(manifold.contacts[0].feature != manifold.contacts[1].feature);
        }
        const Shape round = Disc{0.5};
        for (const Shape& other : {a, Shape{HalfPlane{Vec2(0.0, 1.0), -1.0}}}) {
            const Manifold one = make_manifold(other, pose_a, round, pose_b, 0.1);
            const Manifold turned = make_manifold(round, pose_b, other, pose_a, 0.1);
            REQUIRE(one.count == turned.count);
            if (one.count == 1) REQUIRE(one.contacts[0].feature == (turned.contacts[0].feature ^ 1u));
        }
    }
    CHECK(pairs > 50000);
}

TEST_CASE("exchanging A and B turns the normals of a manifold round and keeps its points")
{
    Random random(505);
    int touching = 0;
    for (int k = 0; k < 5000; ++k) {
        const Shape shapes[] = {random_convex(random), Disc{random.uniform(0.2, 1.0)}, random_convex(random)};
        const Shape& a = shapes[random.below(3)];
        const Shape& b = shapes[random.below(3)];
        const Pose pose_a = random_pose(random, 1.0);
        const Pose pose_b = random_pose(random, 1.0);
        const Manifold ab = make_manifold(a, pose_a, b, pose_b, 0.01);
        const Manifold ba = make_manifold(b, pose_b, a, pose_a, 0.01);
        REQUIRE(ab.count == ba.count);
        touching += ab.count > 0 ? 1 : 0;
        for (int i = 0; i < ab.count; ++i) {
            CHECK((ab.contacts[i].point - ba.contacts[i].point).norm() < 1e-13);
            CHECK((ab.contacts[i].normal + ba.contacts[i].normal).norm() < 1e-13);
            CHECK(std::abs(ab.contacts[i].separation - ba.contacts[i].separation) < 1e-13);
        }
    }
    CHECK(touching > 1000);
}

TEST_CASE(
    "the deepest contact of a manifold is as deep as the separation says, and its points lie between their surfaces")
{
    Random random(506);
    for (int k = 0; k < 5000; ++k) {
        const Polygon a = random_convex(random);
        const Polygon b = random_convex(random);
        const Pose pose_a = random_pose(random, 1.0);
        const Pose pose_b = random_pose(random, 1.0);
        const double gap = separation(Shape(a), pose_a, Shape(b), pose_b);
        const Manifold manifold = make_manifold(Shape(a), pose_a, Shape(b), pose_b, 0.0);
        CHECK((manifold.count > 0) == (gap <= 0.0));
        double deepest = 0.0;
        for (int i = 0; i < manifold.count; ++i) {
            const Contact& contact = manifold.contacts[i];
            deepest = std::min(deepest, contact.separation);
            // Midway between a point of A's boundary and one of B's: half the depth from either
            const Shape point = Disc{k_bound};
            const double half = -0.5 * contact.separation;
            CHECK(separation(Shape(a), pose_a, point, {contact.point, {}}) <= half);
            CHECK(separation(Shape(b), pose_b, point, {contact.point, {}}) <= half);
        }
        if (manifold.count > 0) CHECK(std::abs(deepest - gap) <= k_bound);
    }
}

TEST_CASE("a disc touches a polygon at the nearest point of its boundary, with the normal through the disc's centre")
{
    const Shape square = box(2.0, 2.0);
    const Shape disc = Disc{0.5};
    // Beside a side, off a corner, and with its centre inside
    const Manifold side = make_manifold(square, at(0.0, 0.0), disc, at(1.4, 0.3), 0.0);
    REQUIRE(side.count == 1);
    CHECK(side.contacts[0].separation == doctest::Approx(-0.1));
    CHECK(side.contacts[0].normal.isApprox(Vec2(1.0, 0.0), 1e-15));
    CHECK(side.contacts[0].point.isApprox(Vec2(0.95, 0.3), 1e-15));

    const Manifold corner = make_manifold(disc, at(1.3, 1.3), square, at(0.0, 0.0), 0.0);
    REQUIRE(corner.count == 1);
    CHECK(corner.contacts[0].separation == doctest::Approx(0.3 * std::sqrt(2.0) - 0.5));
    CHECK(corner.contacts[0].normal.isApprox(-Vec2(std::sqrt(0.5), std::sqrt(0.5)), 1e-14));

    const Manifold inside = make_manifold(square, at(0.0, 0.0), disc, at(0.2, -0.9), 0.0);
    REQUIRE(inside.count == 1);
    CHECK(inside.contacts[0].separation == doctest::Approx(-0.6));
    CHECK(inside.contacts[0].normal.isApprox(Vec2(0.0, -1.0), 1e-15));

    CHECK(make_manifold(square, at(0.0, 0.0), disc, at(1.4, 1.4), 0.0).count == 0);
    CHECK(make_manifold(square, at(0.0, 0.0), disc, at(1.4, 1.4), 0.1).count == 1);
}

TEST_CASE("discs touch on the line of their centres, and discs with one centre in any direction")
{
    const Manifold apart = make_manifold(Disc{1.0}, at(0.0, 0.0), Disc{2.0}, at(3.0, 4.0), 2.5);
    REQUIRE(apart.count == 1);
    CHECK(apart.contacts[0].separation == 2.0);
    CHECK(apart.contacts[0].normal.isApprox(Vec2(0.6, 0.8), 1e-15));
    CHECK(apart.contacts[0].point.isApprox(Vec2(1.2, 1.6), 1e-15));
    CHECK(make_manifold(Disc{1.0}, at(0.0, 0.0), Disc{2.0}, at(3.0, 4.0), 1.5).count == 0);

    const Manifold same = make_manifold(Disc{1.0}, at(1.0, 1.0), Disc{2.0}, at(1.0, 1.0), 0.0);
    REQUIRE(same.count == 1);
    CHECK(same.contacts[0].separation == -3.0);
    CHECK(same.contacts[0].normal.norm() == 1.0);
}

TEST_CASE("a half-plane carries a box on two corners, a tilted box on one, a disc on its lowest point")
{
    const HalfPlane ground{Vec2(0.0, 1.0), 0.5};
    const Manifold flat = make_manifold(ground, Pose(), Shape(box(2.0, 1.0)), at(3.0, 0.9), 0.0);
    REQUIRE(flat.count == 2);
    CHECK(flat.contacts[0].separation == doctest::Approx(-0.1));
    CHECK(flat.contacts[1].separation == doctest::Approx(-0.1));
    CHECK(flat.contacts[0].point.y() == doctest::Approx(0.45));
    CHECK(std::abs(flat.contacts[0].point.x() - flat.contacts[1].point.x()) == doctest::Approx(2.0));

    const double tilt = 0.3;
    const double lowest = 0.5 * std::sin(tilt) * 2.0 + 0.5 * std::cos(tilt);
    const Manifold tilted =
        make_manifold(Shape(box(2.0, 1.0)), at(0.0, 0.5 + lowest - 0.01, tilt), ground, Pose(), 0.0);
    REQUIRE(tilted.count == 1);
    CHECK(tilted.contacts[0].separation == doctest::Approx(-0.01));
    CHECK(tilted.contacts[0].normal == Vec2(0.0, -1.0));

    const Manifold disc = make_manifold(ground, Pose(), Disc{1.0}, at(0.0, 1.25), 0.0);
    REQUIRE(disc.count == 1);
    CHECK(disc.contacts[0].separation == -0.25);
    CHECK(disc.contacts[0].point == Vec2(0.0, 0.375));
}

TEST_CASE("polygons that overlap have a contact, thin and small ones, too")
{
    Random random(507);
    const auto thin = [&] {
        const Polygon whole = random_convex(random);
        const double size = std::exp2(random.uniform(-10.0, 0.0));
        const double height = std::exp2(random.uniform(-10.0, 0.0));
        std::vector<Vec2> ring;
        for (const Vec2& v : whole.vertices()) ring.push_back(size * Vec2(v.x(), height * v.y()));
        return Polygon({ring});
    };
    int overlapping = 0;
    for (int k = 0; k < 40000; ++k) {
        const Polygon a = thin();
        const Polygon b = thin();
        const Pose pose_a = random_pose(random, 0.5 * (a.radius() + b.radius()));
        const Pose pose_b = random_pose(random, 0.5 * (a.radius() + b.radius()));
        const double gap = greatest_separation(a, b, relative_pose(pose_a, pose_b)).separation;
        const double margin = 0x1p-16 * std::max(a.radius(), b.radius());
        const Manifold manifold = make_manifold(Shape(a), pose_a, Shape(b), pose_b, 2.0 * margin);
        if (gap >= -1e-12) continue;
        ++overlapping;
        CAPTURE(k);
        CHECK(manifold.count > 0);
    }
    CHECK(overlapping > 5000);
}

TEST_CASE("whatever edges are guessed to part two polygons, those that overlap do so along the same axis to the bit")
{
    Random random(508);
    int overlapping = 0;
    for (int k = 0; k < 40000; ++k) {
        const Polygon a = random_convex(random);
        const Polygon b = random_convex(random);
        const Pose a_from_b = random_pose(random, 0.7 * (a.radius() + b.radius()));
        const double depth = std::exp2(random.uniform(-40.0, -2.0));
        const auto any_edge = [&](const Polygon& polygon) {
            const int count = static_cast<int>(polygon.edges().size());
            return std::min(static_cast<int>(random.uniform(0.0, count)), count - 1);
        };
        const std::optional<Axis> found = overlapping_axis(a, b, a_from_b, {any_edge(a), any_edge(b)}, depth);
        const Axis axis = greatest_separation(a, b, a_from_b);
        CAPTURE(k);
        REQUIRE(found.has_value() == (axis.separation < -depth));
        if (!found) continue;
        ++overlapping;
        CHECK(found->separation == axis.separation);
        CHECK((found->owner == axis.owner && found->edge == axis.edge && found->vertex == axis.vertex));
    }
    CHECK((overlapping > 5000 && overlapping < 35000));
}
