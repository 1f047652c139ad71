#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "collide/separating_axis.hpp"
#include "vertex_edge.hpp"
#include "math/tolerance.hpp"
#include "support/random_polygons.hpp"
#include "support/receipts.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

bool is_near(const Vec2& a, const Vec2& b, double bound = 1e-14)
{
    return (a - b).norm() <= bound;
}

} // namespace

TEST_CASE("a corner has entered over an edge that both its sides cross, if it is on the inner side")
{
    // The edge runs to the left along y = 0: its left, the inside, lies below
    const Vec2 from(2.0, 0.0);
    const Vec2 to(-2.0, 0.0);
    CHECK(corner_has_entered(Vec2(-1, 1), Vec2(0, -0.5), Vec2(1, 1), from, to));
    CHECK_FALSE(corner_has_entered(Vec2(-1, 1), Vec2(0, 0.5), Vec2(1, 1), from, to));
    // One side crosses beyond the edge's end; one doesn't reach; the edge turns the other way
    CHECK_FALSE(corner_has_entered(Vec2(-9, 1), Vec2(0, -0.5), Vec2(1, 1), from, to));
    CHECK_FALSE(corner_has_entered(Vec2(-1, -1), Vec2(0, -0.5), Vec2(1, 1), from, to));
    CHECK_FALSE(corner_has_entered(Vec2(-1, 1), Vec2(0, -0.5), Vec2(1, 1), to, from));
    // Just so: a corner 1e-300 deep has entered, one on the line has not
    CHECK(corner_has_entered(Vec2(-1, 1), Vec2(0, -1e-140), Vec2(1, 1), from, to));
    CHECK_FALSE(corner_has_entered(Vec2(-1, 1), Vec2(0, 0), Vec2(1, 1), from, to));
}

TEST_CASE("a square that stands on its corner enters a floor by that corner, along the floor's normal")
{
    const Polygon floor = box(10, 1);
    const Polygon square = box(1, 1);
    const double half_diagonal = std::sqrt(0.5);
    const Pose tilted = at(1.0, 0.5 + half_diagonal - 0.1, std::numbers::pi / 4.0);
    const std::vector<Contact> contacts = entered_contacts(floor, at(0, 0), square, tilted);
    REQUIRE(contacts.size() == 1);
    CHECK(is_near(contacts[0].normal, Vec2(0, 1)));
    CHECK(contacts[0].separation == doctest::Approx(-0.1).epsilon(1e-14));
    CHECK(is_near(contacts[0].point, Vec2(1.0, 0.45)));

    // From the square's side the normal is the opposite, the point the same
    const std::vector<Contact> back = entered_contacts(square, tilted, floor, at(0, 0));
    REQUIRE(back.size() == 1);
    CHECK(is_near(back[0].normal, Vec2(0, -1)));
    CHECK(is_near(back[0].point, contacts[0].point));
}

TEST_CASE("parallel edges make one contact, at the middle of what they share")
{
    const Polygon floor = box(10, 1);
    const Polygon crate = box(2, 1);
    // Wholly on the floor, half over its end, and touching exactly
    for (const auto& [x, y, middle] :
         {std::tuple(1.0, 0.9, 1.0), std::tuple(5.0, 0.9, 4.5), std::tuple(2.0, 1.0, 2.0)}) {
        const std::vector<Contact> contacts = entered_contacts(floor, at(0, 0), crate, at(x, y));
        REQUIRE(contacts.size() == 1);
        CHECK(is_near(contacts[0].normal, Vec2(0, 1)));
        CHECK(contacts[0].separation == doctest::Approx(y - 1.0));
        CHECK(is_near(contacts[0].point, Vec2(middle, 0.5 * (0.5 + (y - 0.5)))));
    }
    // Turned by a millionth the deeper corner makes the contact
    const std::vector<Contact> tilted = entered_contacts(floor, at(0, 0), crate, at(1.0, 0.9, 1e-6));
    REQUIRE(tilted.size() == 1);
    CHECK(tilted[0].point.x() == doctest::Approx(0.0).epsilon(1e-5));
}

TEST_CASE("corner on corner, the edge that has been entered the least deep gives the normal")
{
    const Polygon square = box(2, 2);
    const std::vector<Contact> right = entered_contacts(square, at(0, 0), square, at(1.9, 1.5));
    REQUIRE(right.size() == 1);
    CHECK(is_near(right[0].normal, Vec2(1, 0)));
    CHECK(right[0].separation == doctest::Approx(-0.1));
    // The facing sides are parallel: the middle of their common stretch
    CHECK(is_near(right[0].point, Vec2(0.95, 0.75)));

    const std::vector<Contact> above = entered_contacts(square, at(0, 0), square, at(-1.5, 1.9));
    REQUIRE(above.size() == 1);
    CHECK(is_near(above[0].normal, Vec2(0, 1)));
}

TEST_CASE("two bars laid crosswise have a contact although no corner has entered")
{
    const std::vector<Contact> contacts = entered_contacts(box(4, 0.5), at(0, 0), box(0.25, 4), at(1, 0));
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].separation == doctest::Approx(-0.25));
    CHECK(is_near(contacts[0].point, Vec2(1, 0)));
}

TEST_CASE("the outside of an edge is where its turning says, not where the centres are")
{
    // A long floor, the square near its end: the line of centres leans, the normal doesn't
    const std::vector<Contact> contacts = entered_contacts(box(20, 1), at(0, 0), box(1, 1), at(9, 0.99));
    REQUIRE(contacts.size() == 1);
    CHECK(is_near(contacts[0].normal, Vec2(0, 1)));

    // In a channel the centres lie the wrong way round: the floor pushes up through a body whose centre is below the
    // rim
    const Polygon channel(
        {{Vec2(-2, -1), Vec2(2, -1), Vec2(2, 9), Vec2(1, 9), Vec2(1, 0), Vec2(-1, 0), Vec2(-1, 9), Vec2(-2, 9)}});
    const std::vector<Contact> in_channel = entered_contacts(channel, at(0, -6), box(1.5, 1), at(0, -5.6));
    REQUIRE(in_channel.size() == 1);
    CHECK(is_near(in_channel[0].normal, Vec2(0, 1)));
    CHECK(in_channel[0].separation == doctest::Approx(-0.1));
}

TEST_CASE("a concave body meets another in several places, one contact each, without being cut up")
{
    // A table on two legs stands in a floor; between the legs there is nothing
    const Polygon table(
        {{Vec2(-3, 0), Vec2(-2, 0), Vec2(-2, 2), Vec2(2, 2), Vec2(2, 0), Vec2(3, 0), Vec2(3, 3), Vec2(-3, 3)}});
    const std::vector<Contact> contacts = entered_contacts(table, at(0, 0), box(20, 1), at(0, -0.4));
    REQUIRE(contacts.size() == 2);
    for (const Contact& contact : contacts) {
        CHECK(is_near(contact.normal, Vec2(0, -1)));
        CHECK(contact.separation == doctest::Approx(-0.1));
        CHECK(std::abs(contact.point.x()) == doctest::Approx(2.5));
    }
    CHECK(contacts[0].feature != contacts[1].feature);

    // A body in a hole, with two of its corners through opposite sides
    const Polygon frame(
        {{Vec2(-2, -2), Vec2(2, -2), Vec2(2, 2), Vec2(-2, 2)}, {Vec2(-1, -1), Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1)}});
    const Polygon diamond({{Vec2(1.1, 0), Vec2(0, 0.5), Vec2(-1.1, 0), Vec2(0, -0.5)}});
    const std::vector<Contact> in_hole = entered_contacts(frame, at(0, 0), diamond, at(0, 0));
    REQUIRE(in_hole.size() == 2);
    for (const Contact& contact : in_hole) {
        CHECK(contact.separation == doctest::Approx(-0.1));
        // Into the hole: against the direction in which the corner lies
        CHECK(contact.normal.x() == doctest::Approx(contact.point.x() > 0.0 ? -1.0 : 1.0));
    }
}

TEST_CASE("where two convex polygons overlap by little, corners and axes tell the same depth and normal")
{
    Random random(621);
    int compared = 0;
    int disagreeing = 0;
    for (int k = 0; k < 40000; ++k) {
        const Polygon a = random_convex(random);
        const Polygon b = random_convex(random);
        const Pose pose_a = random_pose(random, 1.0);
        const Rotation turn = Rotation::of(random.uniform(-3.0, 3.0));
        const Vec2 way(std::cos(0.001 * k), std::sin(0.001 * k));

        // Bring B near along a random line until the axis says a thousandth deep
        Pose pose_b = {pose_a.position + 4.0 * way, turn};
        for (int i = 0; i < 60; ++i) {
            const double gap = greatest_separation(a, b, relative_pose(pose_a, pose_b)).separation;
            if (std::abs(gap + 1e-3) < 1e-12) break;
            pose_b.position -= (gap + 1e-3) * way;
        }
        const Axis axis = greatest_separation(a, b, relative_pose(pose_a, pose_b));
        if (axis.separation < -2e-3 || axis.separation > -1e-4) continue;

        const std::vector<Contact> contacts = entered_contacts(a, pose_a, b, pose_b);
        REQUIRE(contacts.size() == 1);
        const Vec2 normal = axis.owner == Owner::a ? Vec2(pose_a.rotation * a.edges()[axis.edge].normal)
                                                   : Vec2(-(pose_b.rotation * b.edges()[axis.edge].normal));
        const bool agrees =
            std::abs(contacts[0].separation - axis.separation) <= 1e-14 && is_near(contacts[0].normal, normal);
        ++compared;
        disagreeing += agrees ? 0 : 1;
    }
    CHECK(compared > 39000);

    // Where two sharp corners have gone right through each other, no corner is inside over the edge that the axis
    // names. That takes two corners within the depth of each other: a thousandth of the size, in one case of a thousand
    // or less
    CHECK(disagreeing <= compared / 1000);
    RECORD_VALUE("corner.axes.compared", compared);
    RECORD_VALUE("corner.axes.disagreeing", disagreeing);
}

TEST_CASE("every contact of random concave polygons lies where both are, to the depth it tells")
{
    Random random(622);
    int found = 0;
    for (int k = 0; k < 5000; ++k) {
        const Polygon a = random_star(random, k % 2 == 0);
        const Polygon b = random_star(random, k % 3 == 0);
        const Pose pose_a = random_pose(random, 1.5);
        const Pose pose_b = random_pose(random, 1.5);
        const std::vector<Contact> contacts = entered_contacts(a, pose_a, b, pose_b);
        CHECK(contacts.empty() == !boundaries_cross(a, pose_a, b, pose_b));
        for (const Contact& contact : contacts) {
            ++found;
            CHECK(contact.separation <= 1e-13);
            CHECK(contact.normal.norm() == doctest::Approx(1.0));
        }
        // Exchanged, the same pieces are found, with the normals turned round
        const std::vector<Contact> back = entered_contacts(b, pose_b, a, pose_a);
        REQUIRE(back.size() == contacts.size());
        for (const Contact& contact : contacts) {
            double nearest = 1.0;
            for (const Contact& other : back) {
                const double points = (other.point - contact.point).norm();
                const double normals = (other.normal + contact.normal).norm();
                nearest = std::min(nearest, points + normals);
            }
            CHECK(nearest <= 1e-12);
        }
    }
    CHECK(found > 3000);
}

TEST_CASE("the same contacts are found at sizes from a millionth to a million, scaled")
{
    Random random(623);
    for (int k = 0; k < 1000; ++k) {
        const Polygon a = random_star(random, false);
        const Polygon b = random_star(random, false);
        const Pose pose_a = random_pose(random, 1.5);
        const Pose pose_b = random_pose(random, 1.5);
        const std::vector<Contact> contacts = entered_contacts(a, pose_a, b, pose_b);
        for (const double factor : {0x1p-20, 0x1p20}) {
            const auto scaled = [&](const Polygon& polygon) {
                std::vector<Vec2> ring = placed_ring(polygon, Pose());
                for (Vec2& vertex : ring) vertex *= factor;
                return Polygon({ring});
            };
            const Pose far_a = {factor * pose_a.position, pose_a.rotation};
            const Pose far_b = {factor * pose_b.position, pose_b.rotation};
            const std::vector<Contact> same = entered_contacts(scaled(a), far_a, scaled(b), far_b);
            REQUIRE(same.size() == contacts.size());
            for (std::size_t i = 0; i < same.size(); ++i) {
                CHECK(same[i].point == factor * contacts[i].point);
                CHECK(same[i].separation == factor * contacts[i].separation);
                CHECK(same[i].feature == contacts[i].feature);
            }
        }
    }
}

TEST_CASE("boxes on a lattice, whose sides lie on common lines, are told apart without a wrong turn")
{
    // Every offset of a box against another in steps of a quarter: vertices on edges, edges on edges, equal boxes
    const Polygon a = box(2, 1);
    const Polygon b = box(1, 2);
    for (int i = -10; i <= 10; ++i) {
        for (int j = -10; j <= 10; ++j) {
            const double x = 0.25 * i;
            const double y = 0.25 * j;
            const bool overlaps = std::abs(x) < 1.5 && std::abs(y) < 1.5;
            const std::vector<Contact> contacts = entered_contacts(a, at(0, 0), b, at(x, y));
            if (overlaps) CHECK(contacts.size() == 1);
            for (const Contact& contact : contacts) {
                CHECK(contact.separation <= 0.0);
                if (!overlaps) CHECK(contact.separation == 0.0);
            }
            const bool touches = std::max(std::abs(x), std::abs(y)) == 1.5;
            if (!overlaps && !touches) CHECK(contacts.empty());
        }
    }
}
