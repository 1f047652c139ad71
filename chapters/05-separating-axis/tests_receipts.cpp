#include <cmath>
#include <numbers>

#include "collide/manifold.hpp"
#include "collide/separating_axis.hpp"
#include "head_on.hpp"
#include "math/tolerance.hpp"
#include "shadows.hpp"
#include "support/random_polygons.hpp"
#include "support/receipts.hpp"
#include "wrong_corners.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Roundings of a separation, as a share of the coordinates: some twenty operations.
constexpr double k_bound = 20.0 * tolerance::k_epsilon;

/// The axis's direction in the world, from A to B.
Vec2 direction(const Axis& axis, const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b)
{
    if (axis.owner == Owner::a) return pose_a.rotation * a.edges()[axis.edge].normal;
    return -(pose_b.rotation * b.edges()[axis.edge].normal);
}

} // namespace

TEST_CASE("a turned box reaches as far along an axis as the shadows of its sides")
{
    Random random(511);
    for (int k = 0; k < 1000; ++k) {
        const double w_a = random.uniform(0.2, 3.0);
        const double w_b = random.uniform(0.2, 3.0);
        const double h_b = random.uniform(0.2, 3.0);
        const double D = random.uniform(0.0, 4.0);
        const double theta = random.uniform(-3.0, 3.0);
        const Pose pose = placed(D, random.uniform(-2.0, 2.0), theta);
        // [separating-axis.tests.boxes]
        const double s =
            axis_of_edge(box_of(w_a, 1.0), 1, box_of(w_b, h_b), pose).separation;

        const double c = std::abs(std::cos(theta));
        const double sine = std::abs(std::sin(theta));
        const double expected = D - 0.5 * (w_a + w_b * c + h_b * sine);
        CHECK_EQUATION_SCALED("axis.boxes", s, expected, 8.0, k_bound, {"D", D},
                              {"w_a", w_a}, {"w_b", w_b}, {"h_b", h_b}, {"\\theta", theta});
        CHECK_TWIN_SCALED("axis.boxes", s, D - 0.5 * (w_a + w_b * sine + h_b * c), 8.0,
                          k_bound);
        // [separating-axis.tests.boxes]
    }
}


TEST_CASE("a push along an axis widens its gap by the length of the push")
{
    Random random(512);
    for (int k = 0; k < 1000; ++k) {
        const Polygon a = random_convex(random);
        const Polygon b = random_convex(random);
        const Pose pose_a = random_pose(random, 1.0);
        Pose pose_b = random_pose(random, 1.0);
        const Axis axis = greatest_separation(a, b, relative_pose(pose_a, pose_b));
        const double p = random.uniform(0.1, 2.0);
        pose_b.position += p * direction(axis, a, pose_a, b, pose_b);

        const Pose a_from_b = relative_pose(pose_a, pose_b);
        const Pose b_from_a = relative_pose(pose_b, pose_a);
        const double after = axis.owner == Owner::a ? axis_of_edge(a, axis.edge, b, a_from_b).separation
                                                    : axis_of_edge(b, axis.edge, a, b_from_a).separation;
        const double s = axis.separation;
        CHECK_EQUATION_SCALED("axis.push", after, s + p, 8.0, k_bound, {"s", s}, {"p_v", p});
        CHECK_TWIN_SCALED("axis.push", after, s - p, 8.0, k_bound);
    }
}


TEST_CASE("where polygons overlap, no direction has a greater gap than the best edge: "
          "where any has a gap, an edge has")
{
    Random random(513);
    int overlapping = 0;
    for (int k = 0; k < 500; ++k) {
        const Polygon a = random_convex(random);
        const Polygon b = random_convex(random);
        const Pose pose_a = random_pose(random, 1.5);
        const Pose pose_b = random_pose(random, 1.5);
        // [separating-axis.tests.directions]
        const double s =
            greatest_separation(a, b, relative_pose(pose_a, pose_b)).separation;
        double most = -1e300;
        for (int i = 0; i < 720; ++i) {
            const Rotation turn = Rotation::of(i * std::numbers::pi / 360.0);
            most = std::max(most, gap(a, pose_a, b, pose_b, turn * Vec2(1.0, 0.0)));
        }
        overlapping += s < 0.0 ? 1 : 0;
        if (s < 0.0) CHECK(most <= s + 8.0 * k_bound);
        if (most > 8.0 * k_bound) CHECK(s > 0.0);
        // [separating-axis.tests.directions]
    }
    CHECK(overlapping > 100);
    CHECK(overlapping < 400);
}

TEST_CASE("the shortest push parts two polygons, and a push shorter by a thousandth in any "
          "direction does not")
{
    Random random(514);
    int tried = 0;
    for (int k = 0; k < 1000; ++k) {
        const Polygon a = random_convex(random);
        const Polygon b = random_convex(random);
        const Pose pose_a = random_pose(random, 0.7);
        const Pose pose_b = random_pose(random, 0.7);
        const Axis axis = greatest_separation(a, b, relative_pose(pose_a, pose_b));
        if (axis.separation > -0.01) continue;
        ++tried;
        const auto after = [&](const Vec2& push) {
            const Pose pushed = {pose_b.position + push, pose_b.rotation};
            return greatest_separation(a, b, relative_pose(pose_a, pushed)).separation;
        };
        const Vec2 n = direction(axis, a, pose_a, b, pose_b);
        CHECK(std::abs(after(-axis.separation * n)) <= 8.0 * k_bound);
        for (int i = 0; i < 36; ++i) {
            const Rotation turn = Rotation::of(i * std::numbers::pi / 18.0);
            const Vec2 shorter = -0.999 * axis.separation * (turn * n);
            CHECK(after(shorter) < 0.0);
        }
    }
    CHECK(tried > 300);
}


TEST_CASE("a crate that hangs over the end of a shelf is cut off at the end")
{
    Random random(515);
    for (int k = 0; k < 1000; ++k) {
        const double L = random.uniform(4.0, 8.0);
        const Polygon shelf = box_of(L, 1.0);
        const Polygon crate = box_of(1.0, 1.0);

        // Over the left end, leaning to the right: the shelf's top has the greatest separation
        const double tilt = random.uniform(-0.05, -0.005);
        const Pose pose = placed(-0.5 * L + random.uniform(-0.3, 0.3), 0.9, tilt);
        const Manifold manifold = make_manifold(shelf, placed(0.0, 0.0), crate, pose, 0.0);
        REQUIRE(manifold.count == 2);
        const Contact& first = manifold.contacts[0];
        const Contact& second = manifold.contacts[1];
        const double s = first.point.x() < second.point.x() ? first.separation : second.separation;

        // The crate's lower corners, as the shelf's top sees them: it runs to the left from its right end
        const auto corner = [&](double x) {
            const Vec2 local(x, -0.5);
            return Vec2(pose.position.x() + std::cos(tilt) * local.x() - std::sin(tilt) * local.y(),
                        pose.position.y() + std::sin(tilt) * local.x() + std::cos(tilt) * local.y());
        };
        const double u_0 = 0.5 * L - corner(0.5).x();
        const double u_1 = 0.5 * L - corner(-0.5).x();
        const double s_0 = corner(0.5).y() - 0.5;
        const double s_1 = corner(-0.5).y() - 0.5;
        const double expected = s_0 + (L - u_0) / (u_1 - u_0) * (s_1 - s_0);
        CHECK_EQUATION_SCALED("axis.cut", s, expected, 8.0, k_bound, {"s_0", s_0}, {"s_1", s_1}, {"u_0", u_0},
                              {"u_1", u_1}, {"L", L});
        CHECK_TWIN_SCALED("axis.cut", s, s_0 + (L - u_0) / L * (s_1 - s_0), 8.0, k_bound);
    }
}


TEST_CASE("two bodies a million kilometres from the origin see each other to the bit as "
          "they do near it")
{
    const Polygon a = regular(5, 1.0);
    const Polygon b = regular(7, 1.0);
    Random random(516);
    for (int k = 0; k < 1000; ++k) {
        // Places on a grid of 2^-20 m, moved by 2^30 m: sums and differences are exact
        const auto on_grid = [&] {
            return std::floor(random.uniform(-1.5, 1.5) * 1048576.0) / 1048576.0;
        };
        Pose pose_a = placed(on_grid(), on_grid(), random.uniform(-3.0, 3.0));
        Pose pose_b = placed(on_grid(), on_grid(), random.uniform(-3.0, 3.0));
        const double near =
            greatest_separation(a, b, relative_pose(pose_a, pose_b)).separation;
        const Vec2 far_away(1073741824.0, -1073741824.0);
        pose_a.position += far_away;
        pose_b.position += far_away;
        CHECK(greatest_separation(a, b, relative_pose(pose_a, pose_b)).separation == near);
    }
}

// [separating-axis.tests.bars]
TEST_CASE("corners miss crossing bars, which intervals find")
{
    const Aabb lying = bounding_box(box_of(4.0, 0.5), placed(0.0, 0.0));
    const Aabb standing = bounding_box(box_of(0.5, 4.0), placed(0.0, 0.0));
    CHECK(overlap(lying, standing));
    CHECK_FALSE(wrong_overlap(lying, standing));
}
// [separating-axis.tests.bars]

TEST_CASE("corners miss some of the boxes that overlap, whatever their sides")
{
    Random random(517);
    int overlapping = 0;
    int missed = 0;
    for (int k = 0; k < 100000; ++k) {
        const auto random_box = [&] {
            const double width = random.uniform(0.1, 4.0);
            return box_of(width, random.uniform(0.1, 4.0));
        };
        const Polygon a = random_box();
        const Polygon b = random_box();
        const Aabb box_a = bounding_box(a, placed(0.0, 0.0));
        const double x = random.uniform(-2.0, 2.0);
        const Aabb box_b = bounding_box(b, placed(x, random.uniform(-2.0, 2.0)));
        if (!overlap(box_a, box_b)) continue;
        ++overlapping;
        missed += wrong_overlap(box_a, box_b) ? 0 : 1;
    }
    CHECK(missed > 0);
    RECORD_VALUE("separating-axis.missed", 100.0 * missed / overlapping);
}

// [separating-axis.tests.head_on]
TEST_CASE("two squares head on bounce off their facing sides: by the nearest edge they "
          "pass through each other")
{
    const auto gap_after = [](Rule rule, double higher) {
        HeadOn meeting;
        meeting.pose_b.position.y() = higher;
        for (int k = 0; k < 120; ++k) meeting.step(rule, 1.0 / 60.0);
        return meeting.pose_b.position.x() - meeting.pose_a.position.x();
    };
    for (const double higher : {0.0, 0.01, 0.1, 0.5})
        CHECK(gap_after(Rule::greatest_separation, higher) > 1.0);

    // The wrong rule is right for squares that are well out of line, and wrong where they
    // are in line
    CHECK(gap_after(Rule::nearest_edge, 0.1) > 1.0);
    CHECK(gap_after(Rule::nearest_edge, 0.0) < -1.0);
}
// [separating-axis.tests.head_on]
