#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "collide/separation.hpp"
#include "rest/near_points.hpp"
#include "rest/outline_points.hpp"
#include "rest/rest_engine.hpp"
#include "stages.hpp"
#include "support/random_polygons.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("a contact foresees when a falling box closes its gap, and how fast")
{
    const double gap = 0.01;  // [m]
    const double speed = 1.0; // [m/s]
    RestData data = data_of({ground(), box_at({0.0, 0.5 + gap}, {0.0, -speed})});
    const std::vector<ContactPoint> found = contacts_of(data);
    REQUIRE(found.size() == 2);
    // gap = v t + g t^2 / 2
    const double arrival = (std::sqrt(speed * speed + 2.0 * k_g * gap) - speed) / k_g;
    for (const ContactPoint& c : found) {
        CHECK(c.gap == doctest::Approx(gap).epsilon(1e-12));
        CHECK(c.closes_at == doctest::Approx(arrival).epsilon(1e-12));
        CHECK(c.closing_speed == doctest::Approx(speed + k_g * arrival).epsilon(1e-12));
        CHECK(c.normal == 0.0);
        CHECK(c.n_y == 1.0);
    }
}

TEST_CASE("what flies away, or lies where it is, closes nothing")
{
    RestData data = data_of({ground(), box_at({0.0, 0.5}), box_at({4.0, 0.51}, {0.0, 1.0})});
    for (const ContactPoint& c : contacts_of(data)) CHECK(std::isinf(c.closes_at));
}

TEST_CASE("a corner at the bottom of a notch touches both flanks, along their normals")
{
    // A static V of right angle, and a box that stands in it on one corner
    for (const double lean : {0.0, 0.1, -0.3}) {
        RestBody notch{Polygon({{Vec2(-2.0, 1.0), Vec2(-2.0, -1.0), Vec2(2.0, -1.0), Vec2(2.0, 1.0), Vec2(1.0, 1.0),
                                 Vec2(0.0, 0.0), Vec2(-1.0, 1.0)}}),
                       {},
                       {},
                       {0.0, 0.5}};
        notch.is_static = true;
        const std::vector<Vec2> spike = {Vec2(0.0, 0.0), Vec2(0.1, 0.5), Vec2(-0.1, 0.5)};
        RestBody rod{Polygon({spike}), {}, {1.0, 6.0}, {0.0, 0.5}};
        rod.acceleration = Vec2(0.0, -k_g);
        rod.state.angle = lean;
        RestData data = data_of({notch, rod});
        const std::vector<ContactPoint> found = contacts_of(data);
        REQUIRE(found.size() == 2);
        const double share = std::sqrt(0.5);
        for (const ContactPoint& c : found) {
            CHECK(std::abs(c.gap) <= 1e-15);
            CHECK(c.n_y == doctest::Approx(share).epsilon(1e-12));
            CHECK(std::abs(c.n_x) == doctest::Approx(share).epsilon(1e-12));
        }
        CHECK(found[0].n_x * found[1].n_x < 0.0);
    }
}

TEST_CASE("corners that have slid past each other: sides that cross touch, though neither corner is inside")
{
    // The stone's left corner lies beyond the plank's lower left one, and above it; its right corner is a little below
    RestBody plank{Polygon({{Vec2(-0.388594, -0.0753964), Vec2(0.388594, -0.0753964), Vec2(0.388594, 0.0753964),
                             Vec2(-0.388594, 0.0753964)}}),
                   {},
                   {1.0, 6.0},
                   {0.0, 0.5}};
    plank.state.position = Vec2(-4.6621385593477829, 0.15913785489046628);
    plank.state.angle = std::atan2(-0.13384096843129029, 0.9910028229875909);
    RestBody stone{Polygon({{Vec2(0.0514389, 0.00526448), Vec2(0.0119378, 0.0635715), Vec2(-0.0638522, 0.0859409),
                             Vec2(-0.05164, -0.0541721), Vec2(0.0157392, -0.0621132), Vec2(0.101091, -0.0505679)}}),
                   {},
                   {1.0, 6.0},
                   {0.0, 0.5}};
    stone.state.position = Vec2(-4.9837365698819402, 0.060215594037458645);
    stone.state.angle = std::atan2(0.11803982872803963, 0.99300886140751787);
    RestData data = data_of({plank, stone});
    const std::vector<ContactPoint> found = contacts_of(data);
    const auto is_overlap = [](const ContactPoint& c) { return c.gap < -0.001 && c.n_y < -0.9; };
    CHECK(std::any_of(found.begin(), found.end(), is_overlap));
}

TEST_CASE("a crossing is found beside a point that is known, at any depth")
{
    // The upper end of a plank has passed the tip of a body with notches, by so much, and lies beyond its upper side;
    // its lower end leans on the body's right side
    const std::vector<Vec2> body = {Vec2(0.0, 0.0), Vec2(4.0, 1.0), Vec2(3.0, 3.0),
                                    Vec2(4.0, 6.0), Vec2(0.0, 5.2), Vec2(1.0, 3.0)};
    RestBody notched{Polygon({body}), {}, {}, {0.0, 0.5}};
    notched.is_static = true;
    const Vec2 side = (body[3] - body[2]).normalized();
    for (const double depth : {1e-9, 1e-4, 3e-3, 0.02}) {
        const double length = 1.0;
        const double width = 0.2;
        const Vec2 foot = body[3] - (length + 0.3 * depth) * side; // the tip is beyond the plank's end, too
        // Turn the plank about its foot until its upper end is so deep
        const double turn = depth / length;
        const Vec2 along = Rotation::of(turn) * side;
        const Vec2 across(along.y(), -along.x());
        RestBody plank{Polygon({{Vec2(-0.5 * width, -0.5 * length), Vec2(0.5 * width, -0.5 * length),
                                 Vec2(0.5 * width, 0.5 * length), Vec2(-0.5 * width, 0.5 * length)}}),
                       {},
                       {1.0, 6.0},
                       {0.0, 0.5}};
        plank.state.position = foot + 0.5 * length * along + 0.5 * width * across;
        plank.state.angle = std::atan2(along.y(), along.x()) - 0.5 * std::acos(-1.0);
        RestData data = data_of({notched, plank});
        double deepest = 0.0;
        for (const ContactPoint& c : contacts_of(data)) deepest = std::min(deepest, c.gap);
        CAPTURE(depth);
        CHECK(-deepest > 0.5 * depth);
        CHECK(-deepest < 1.5 * depth);
    }
}

namespace {

Manifold points_of_two(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b, double margin)
{
    NearMemory nothing;
    const std::optional<Manifold> over_edge = near_points(a, pose_a, b, pose_b, margin, nothing);
    if (over_edge) return *over_edge;
    const Outline outline_a(a, make_collision_shape(a));
    const Outline outline_b(b, make_collision_shape(b));
    return outline_points({outline_a, 0, pose_a}, {outline_b, 0, pose_b}, margin, 1e-12);
}

} // namespace

TEST_CASE("the points of two polygons that are apart have the nearest one among them, as near as their distance")
{
    // A corner past the end of the side that it is nearest to was left out, where another point lay over the side
    Random random(1);
    int apart = 0;
    for (int k = 0; k < 20000; ++k) {
        const Shape a = random_convex(random);
        const Shape b = random_convex(random);
        const Pose pose_a = random_pose(random, 1.5);
        const Pose pose_b = random_pose(random, 1.5);
        const double between = separation(a, pose_a, b, pose_b);
        if (!(between > 1e-9 && between < 0.2)) continue;
        ++apart;
        const Manifold manifold = points_of_two(a, pose_a, b, pose_b, 0.3);
        double lowest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < manifold.count; ++i) lowest = std::min(lowest, manifold.contacts[i].separation);
        CHECK(std::abs(lowest - between) <= 1e-12);
    }
    CHECK(apart > 1000);
}

TEST_CASE("a corner over the second of two edges on one line is as near as over the first")
{
    // The lines of both edges part the two shapes equally well, and only one of the edges lies below the corner
    const Shape table = Polygon({{Vec2(-1.0, -1.0), Vec2(1.0, -1.0), Vec2(1.0, 0.0), Vec2(0.0, 0.0), Vec2(-1.0, 0.0)}});
    const Shape above = box(0.2, 0.2);
    for (const double x : {-0.5, 0.5}) {
        const Pose pose{Vec2(x, 0.1 * std::sqrt(2.0) + 1e-3), Rotation::of(0.25 * std::acos(-1.0))};
        const Manifold manifold = points_of_two(table, Pose(), above, pose, 0.01);
        CAPTURE(x);
        REQUIRE(manifold.count > 0);
        CHECK(manifold.contacts[0].separation == doctest::Approx(1e-3).epsilon(1e-9));
        CHECK(manifold.contacts[0].normal.y() == doctest::Approx(1.0).epsilon(1e-9));
    }
}

TEST_CASE("bodies that are cut into parts have their nearest point among the points of their parts, too")
{
    Random random(1);
    int apart = 0;
    for (int k = 0; k < 40000; ++k) {
        RestBody a{random_star(random, false), {}, {1.0, 6.0}, {0.0, 0.5}};
        RestBody b = a;
        if (random.below(2) == 0) b.shape = random_star(random, false);
        else b.shape = random_convex(random);
        const double direction = random.uniform(0.0, 6.3);
        const double distance = random.uniform(0.3, 2.5);
        a.state.angle = random.uniform(0.0, 6.3);
        b.state.angle = random.uniform(0.0, 6.3);
        b.state.position = {distance * std::cos(direction), distance * std::sin(direction)};
        const double between = separation(a.shape, pose_of(a.state), b.shape, pose_of(b.state));
        if (!(between > 1e-9 && between < 0.01)) continue;
        ++apart;
        RestData data = data_of({a, b});
        double lowest = std::numeric_limits<double>::infinity();
        for (const ContactPoint& c : contacts_of(data)) lowest = std::min(lowest, c.gap);
        CHECK(std::abs(lowest - between) <= 1e-12);
    }
    CHECK(apart > 100);
}

TEST_CASE("what stands and hasn't moved is not looked at again, with the bits of an engine that looks in every step")
{
    // Two loose tiles lie flush on the ground with a box on them both; beside them a tower of three, and two that no
    // more than half a step brings within reach of each other
    std::vector<RestBody> bodies = {ground(),           box_at({0.0, 0.5}), box_at({1.0, 0.5}),
                                    box_at({0.4, 1.5}), box_at({5.0, 0.5}), box_at({5.0, 1.5}),
                                    box_at({5.0, 2.5}), box_at({8.0, 0.5}), box_at({9.037, 0.5})};
    RestOptions options;
    options.sleeps = false;
    RestEngine remembers(bodies, options);
    RestEngine forgets(bodies, options);
    double length = options.step;
    const auto both_step = [&](int steps) {
        bool same = true;
        for (int k = 0; k < steps; ++k) {
            forgets.go_on_from(forgets.memory());
            for (RestEngine* engine : {&forgets, &remembers}) engine->step_by(length, engine->time() + length);
            same = same && forgets.hash() == remembers.hash() && forgets.counts().points == remembers.counts().points;
        }
        CHECK(same);
    };
    const auto looks_in = [&](int steps) {
        const std::int64_t before = remembers.counts().manifolds;
        both_step(steps);
        return remembers.counts().manifolds - before;
    };
    both_step(5);
    CHECK(looks_in(20) == 0);

    const auto throw_both = [&](int body, const Vec2& velocity, double spin, double lift = 0.0) {
        for (RestEngine* engine : {&remembers, &forgets}) {
            BodyState state = engine->state(body);
            state.position.y() += lift;
            state.velocity = velocity;
            state.spin = spin;
            engine->set_state(body, state);
        }
    };
    length *= 0.5;
    both_step(2);
    length *= 2.0;
    both_step(2);
    // From where it stood, so that places alone don't tell: the box slides over the seam, and is not tripped
    throw_both(3, Vec2(3.0, 0.0), 0.0);
    CHECK(looks_in(1) > 0);
    CHECK(std::abs(remembers.state(3).spin) <= 1e-12);
    CHECK(remembers.state(3).velocity.x() > 2.5);
    both_step(60);
    // By its last digit, and again, so that it was awake when it was looked at last; by a turn, and by a fall
    throw_both(5, Vec2::Zero(), 0.0, 0x1p-52);
    CHECK(looks_in(1) > 0);
    throw_both(5, Vec2::Zero(), 0.0, 0x1p-52);
    CHECK(looks_in(1) > 0);
    throw_both(4, Vec2::Zero(), 2.0);
    both_step(60);
    throw_both(6, Vec2(-4.0, -1.0), -3.0);
    both_step(240);
    CHECK(looks_in(20) == 0);
}
