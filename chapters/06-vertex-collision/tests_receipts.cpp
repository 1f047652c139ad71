#include <algorithm>
#include <cmath>
#include <numbers>

#include "collide/touching.hpp"
#include "vertex_edge.hpp"
#include "math/random.hpp"
#include "math/sine_cosine.hpp"
#include "misjudged.hpp"
#include "scenes.hpp"
#include "support/receipts.hpp"
#include "wrong_normal.hpp"

using namespace flying;
using namespace flying::corner;

TEST_CASE("a square on its corner enters a floor as deep as its sides say")
{
    Random random(661);
    for (int k = 0; k < 1000; ++k) {
        const double w = random.uniform(0.5, 2.0);
        const double phi = random.uniform(0.1, 1.4);
        const SineCosine turned = sine_cosine(phi);
        const double below = w / 2 * (turned.cosine + turned.sine);
        const double y = below - random.uniform(0.01, 0.1) * w;
        const double x = random.uniform(-3.0, 3.0);
        // [corner.tests.depth]
        const Pose pose = at(x, 0.5 + y, phi);
        const auto contacts = entered_contacts(box(10, 1), at(0, 0), box(w, w), pose);
        REQUIRE(contacts.size() == 1);

        // Coordinates are below 8, roundings a few units in their last place
        const double bound = 1e-14;
        const double d = -contacts[0].separation;
        CHECK_EQUATION_SCALED("corner.depth", d, below - y, 1.0, bound, {"w", w}, {"\\varphi", phi}, {"y", y});
        CHECK_TWIN_SCALED("corner.depth", d, w / 2 * (turned.cosine - turned.sine) - y, 1.0, bound);
        const double foot = x - w / 2 * (turned.cosine - turned.sine);
        const double found = contacts[0].point.x();
        CHECK_EQUATION_SCALED("corner.foot", found, foot, 1.0, bound, {"x", x}, {"w", w}, {"\\varphi", phi});
        CHECK_TWIN_SCALED("corner.foot", found, x - w / 2 * (turned.cosine + turned.sine), 1.0, bound);
        // [corner.tests.depth]
    }
}

// [corner.tests.cone]
TEST_CASE("two squares that meet corner on corner push along the mean of their diagonals")
{
    constexpr double pi = std::numbers::pi;
    Random random(665);
    std::vector<Touch> touches;
    for (int k = 0; k < 1000; ++k) {
        const double alpha = random.uniform(-0.7, 0.7);
        const double beta = random.uniform(-0.7, 0.7);

        // A's corner points up but for alpha, B's down but for beta; both tips lie at the origin
        const Rotation turn_a = Rotation::of(pi / 4 + alpha);
        const Rotation turn_b = Rotation::of(-3 * pi / 4 + beta);
        const Vec2 tip(0.5, 0.5);
        const Pose pose_a{-(turn_a * tip), turn_a};
        const Pose pose_b{-(turn_b * tip), turn_b};
        find_touches(box(1, 1), pose_a, box(1, 1), pose_b, 1e-9, touches);
        REQUIRE(touches.size() == 1);
        const Vec2 normal = touches[0].normal;
        const double psi = std::atan2(normal.y(), normal.x());

        // Six rotations and an arc tangent, a few roundings each
        const double bound = 4e-15;
        CHECK_EQUATION("corner.cone", psi, pi / 2 + (alpha + beta) / 2, bound, {"\\alpha", alpha}, {"\\beta", beta});
        CHECK_TWIN("corner.cone", psi, pi / 2 + (alpha + 2 * beta) / 3, bound);
    }
}
// [corner.tests.cone]

TEST_CASE("two faces whose ends meet push along their common normal, and sharp tips in a notch not at all")
{
    // Flush: B on the right half of A's upper side, their right sides in one line
    std::vector<Touch> touches;
    find_touches(box(2, 1), at(0, 0), box(1, 1), at(0.5, 1.0), 1e-9, touches);
    REQUIRE(touches.size() == 2);
    for (const Touch& touch : touches) CHECK((touch.normal - Vec2(0, 1)).norm() < 1e-15);

    // A quarter apart and more, no direction parts two right angles: one has come past the other
    const Rotation turn_b = Rotation::of(-3 * std::numbers::pi / 4 + 1.6);
    const Pose pose_a{-(Rotation::of(std::numbers::pi / 4) * Vec2(0.5, 0.5)), Rotation::of(std::numbers::pi / 4)};
    find_touches(box(1, 1), pose_a, box(1, 1), {-(turn_b * Vec2(0.5, 0.5)), turn_b}, 1e-9, touches);
    CHECK(touches.empty());
}

TEST_CASE("a crate that lies flat is held in the middle of what it shares")
{
    Random random(662);
    for (int k = 0; k < 1000; ++k) {
        const double width = random.uniform(0.5, 4.0);
        const double x = random.uniform(-6.0, 6.0);
        const double x_1 = x - width / 2;
        const double x_2 = x + width / 2;
        // Leave out a crate beside the floor, or in from its side
        if (std::min(x_2, 5.0) - std::max(x_1, -5.0) < 0.2) continue;
        const auto contacts = entered_contacts(box(10, 1), at(0, 0), box(width, 1), at(x, 0.95));
        REQUIRE(contacts.size() == 1);
        const double middle = (std::max(x_1, -5.0) + std::min(x_2, 5.0)) / 2;
        const double found = contacts[0].point.x();
        CHECK_EQUATION_SCALED("corner.middle", found, middle, 5.0, 1e-15, {"x_1", x_1}, {"x_2", x_2}, {"u_1", -5.0},
                              {"u_2", 5.0});
        CHECK_TWIN_SCALED("corner.middle", found, (x_1 + x_2) / 3, 5.0, 1e-15);
    }
}

TEST_CASE("two bars laid crosswise are as deep as the narrower is wide")
{
    Random random(663);
    for (int k = 0; k < 200; ++k) {
        const double b = random.uniform(0.1, 0.9);
        const double h = random.uniform(0.1, 0.9);
        const auto contacts = entered_contacts(box(4, h), at(0, 0), box(b, 4), at(random.uniform(-1.0, 1.0), 0));
        REQUIRE(contacts.size() == 1);
        const double d = -contacts[0].separation;
        CHECK_EQUATION_SCALED("corner.width", d, std::min(b, h), 1.0, 2e-15, {"w_1", b}, {"w_2", h});
        CHECK_TWIN_SCALED("corner.width", d, std::max(b, h), 1.0, 2e-15);
    }
}

// [corner.tests.int]
TEST_CASE("a turn in an int misjudges squares of a metre, and hardly any of a hundred metres")
{
    const int unit = misjudged_pairs(1.0, 1000);
    const int large = misjudged_pairs(100.0, 1000);
    CHECK(unit > 400);
    // Some turn must come within one square metre of zero, where a typical one is of ten
    // thousand
    CHECK(large < 10);
    RECORD_VALUE("corner.int.unit", unit);
    RECORD_VALUE("corner.int.large", large);

    // The exact turn doesn't know how long a metre is
    CHECK(wrong_turn(Vec2(0, 0), Vec2(1, 0), Vec2(0.25, 0.5)) == 0);
    CHECK(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(0.25, 0.5)) == 1);
}
// [corner.tests.int]

// [corner.tests.longer]
TEST_CASE("a floor made longer at its far end pushes a crate as before")
{
    const auto floor = [](double left) {
        return Polygon({{Vec2(-left, -1), Vec2(10, -1), Vec2(10, 0), Vec2(-left, 0)}});
    };
    const Pose crate = at(8.0, 0.49);
    const auto push = [&](double left) { return entered_contacts(floor(left), at(0, 0), box(1, 1), crate).front(); };
    const auto middle = [](double left) { return Vec2(0.5 * (10.0 - left), -0.5); };
    for (const double left : {20.0, 40.0, 1000.0}) {
        CHECK(push(left).normal == push(10.0).normal);
        CHECK(push(left).separation == push(10.0).separation);

        const Vec2 before = wrong_normal(middle(10.0), crate.position);
        const Vec2 after = wrong_normal(middle(left), crate.position);
        CHECK((after - before).norm() > 0.04);
    }
}
// [corner.tests.longer]

TEST_CASE("by the centres, a crate that falls straight is thrown along the floor")
{
    Random random(664);
    for (int k = 0; k < 200; ++k) {
        const double v = random.uniform(0.5, 5.0);
        const double x = random.uniform(0.5, 9.0);
        const double y = random.uniform(0.5, 1.0);
        const Vec2 after = bounced(Vec2(0.0, -v), wrong_normal(Vec2::Zero(), Vec2(x, y)));
        const double closed = 2 * v * x * y / (x * x + y * y);
        CHECK_EQUATION("corner.lean", after.x(), closed, 4e-15, {"V", v}, {"x", x}, {"y", y});
        CHECK_TWIN("corner.lean", after.x(), v * x * y / (x * x + y * y), 4e-15);
    }
}
