#include <doctest/doctest.h>

#include "response/several_points.hpp"
#include "support/impacts.hpp"

using namespace impacts;

namespace {

using Points = std::vector<ImpactPoint>;

ImpactResult strike(const ImpactBody& a, const ImpactBody& b, const Points& points, const Material& material)
{
    return flying::resolve_impact(a, b, points, material);
}

// Corners of a box of half sizes w, h that lies on a floor
Points floor_points(double w, double h)
{
    const Vec2 up(0.0, 1.0);
    return {{{-w, 0.0}, {-w, -h}, up}, {{w, 0.0}, {w, -h}, up}};
}

ImpactBody box(double m, double w, double h, const Vec2& velocity, double spin)
{
    return body(m, m * (w * w + h * h) / 3.0, velocity, spin);
}

// Points of contact as two bodies have them: each at one place of the world, so that r_a - r_b is the same for all
// Two to `most` of them, with one to `most_normals` different normals
Points random_points(flying::Random& random, int most, int most_normals)
{
    const int count = 2 + random.below(most - 1);
    const int normals = 1 + random.below(most_normals);
    const Vec2 between = in_square(random, 1.0);
    std::vector<Vec2> directions;
    for (int i = 0; i < normals; ++i) directions.push_back(unit(random.uniform(0.0, 6.28)));
    Points points;
    for (int i = 0; i < count; ++i) {
        const Vec2 r_a = in_square(random, 1.0);
        points.push_back({r_a, r_a - between, directions[random.below(normals)]});
    }
    return points;
}

double worst_approach(const ImpactBody& a, const ImpactBody& b, const Points& points, const ImpactResult& after)
{
    double worst = 0.0;
    for (const ImpactPoint& point : points)
        worst = std::max(worst, -normal_speed(after, point) / speed_scale(a, b, after, point));
    return worst;
}

} // namespace

// ---- Landing flat ---------------------------------------------------------------------------------------------------

TEST_CASE("a square that lands flat is thrown back without a trace of spin, to the bit")
{
    flying::Random random(721);
    for (int i = 0; i < 20'000; ++i) {
        const double w = spread(random, 0.01, 100.0);
        const double e = random.uniform();
        const double fall = random.uniform(0.1, 3.0);
        const double mu = random.below(2) == 0 ? 0.0 : random.uniform();
        const ImpactResult after =
            strike(k_wall, box(spread(random, 0.1, 10.0), w, w, {0.0, -fall}, 0.0), floor_points(w, w), {e, mu});
        CHECK(after.any_push);
        CHECK(after.ended);
        CHECK(after.spin_b == 0.0);
        CHECK(after.velocity_b.x() == 0.0);
        CHECK(std::abs(after.velocity_b.y() - e * fall) <= 8.0 * k_epsilon * fall);
    }
}

TEST_CASE("a square that lands flat on its middle and corners, in any order of the points, does the same")
{
    Points points = floor_points(0.5, 0.5);
    points.push_back({{0.0, 0.0}, {0.0, -0.5}, {0.0, 1.0}});
    points.push_back({{0.25, 0.0}, {0.25, -0.5}, {0.0, 1.0}});
    points.push_back(points[0]);
    const ImpactBody falling = box(2.0, 0.5, 0.5, {0.0, -1.0}, 0.0);
    const ImpactResult first = strike(k_wall, falling, points, {0.7, 0.3});
    CHECK(first.spin_b == 0.0);
    for (int i = 0; i < 5; ++i) {
        std::rotate(points.begin(), points.begin() + 1, points.end());
        CHECK(same_bits(strike(k_wall, falling, points, {0.7, 0.3}), first));
    }
}

TEST_CASE("two squares that meet face to face exchange what two discs would, without spin")
{
    const Points points{{{0.5, -0.5}, {-0.5, -0.5}, {1.0, 0.0}}, {{0.5, 0.5}, {-0.5, 0.5}, {1.0, 0.0}}};
    const ImpactResult after =
        strike(box(1.0, 0.5, 0.5, {2.0, 0.0}, 0.0), box(3.0, 0.5, 0.5, {-2.0, 0.0}, 0.0), points, {1.0, 0.0});
    CHECK(after.spin_a == 0.0);
    CHECK(after.spin_b == 0.0);
    CHECK(std::abs(after.velocity_a.x() + 4.0) < 16.0 * k_epsilon);
    CHECK(std::abs(after.velocity_b.x()) < 16.0 * k_epsilon);
}

TEST_CASE("a box that lands on two points beside its middle obeys Newton's law at both, if both must push")
{
    // Falling and turning: v_i = -1 + omega x_i. With both pushing, fall and spin are both thrown back
    flying::Random random(722);
    for (int i = 0; i < 20'000; ++i) {
        const double left = random.uniform(-1.0, -0.1);
        const double right = random.uniform(0.1, 1.0);
        const double spin = random.uniform(-0.9, 0.9);
        const double e = random.uniform();
        const double fall = -1.0;
        const Vec2 up(0.0, 1.0);
        const Points points{{{left, 0.0}, {left, -1.0}, up}, {{right, 0.0}, {right, -1.0}, up}};
        const ImpactBody falling = body(1.0, random.uniform(0.3, 1.0), {0.5, fall}, spin);
        const ImpactResult after = strike(k_wall, falling, points, {e, 0.0});

        // Find both impulses by hand: their sum and their moment about the middle
        const double sum = (1.0 + e) * -fall;
        const double moment = (1.0 + e) * -spin / falling.inertia.inv_moment_of_inertia;
        const double j_right = (moment - left * sum) / (right - left);
        const double j_left = sum - j_right;
        if (j_left < 1e-9 || j_right < 1e-9) continue;
        CHECK(std::abs(after.velocity_b.y() + e * fall) < 64.0 * k_epsilon);
        CHECK(std::abs(after.spin_b + e * spin) < 64.0 * k_epsilon);
        CHECK(after.velocity_b.x() == 0.5);
    }
}

TEST_CASE("where one corner of a tilted landing would be pulled, the other takes it all and the first is not held")
{
    // Left corner under the middle, right one far out: the left alone stops the fall
    const Vec2 up(0.0, 1.0);
    const Points points{{{0.0, 0.0}, {0.0, -1.0}, up}, {{1.0, 0.0}, {1.0, -1.0}, up}};
    const ImpactResult after = strike(k_wall, body(1.0, 1.0, {0.0, -1.0}, 0.5), points, {0.0, 0.0});
    CHECK(after.velocity_b.y() == 0.0);
    CHECK(after.spin_b == 0.5);
    CHECK(after.ended);
}

// ---- Friction -------------------------------------------------------------------------------------------------------

TEST_CASE("a box that lands flat and sliding at e = 0 lies flat and loses mu times its fall, up to a stop")
{
    flying::Random random(723);
    double worst = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const double w = random.uniform(0.5, 2.0);
        const double h = random.uniform(0.05, 1.0) * w;
        const double mu = random.uniform(0.0, 0.9);
        const double fall = random.uniform(0.1, 2.0);
        const double slide = random.uniform(-2.0, 2.0);
        const ImpactResult after = strike(k_wall, box(1.0, w, h, {slide, -fall}, 0.0), floor_points(w, h), {0.0, mu});
        CHECK(after.ended);
        const double left = std::copysign(std::max(0.0, std::abs(slide) - mu * fall), slide);
        worst = std::max(
            {worst, std::abs(after.velocity_b.x() - left), std::abs(after.velocity_b.y()), std::abs(after.spin_b) * w});
    }
    CHECK(worst < 128.0 * k_epsilon);
}

TEST_CASE("a box that lands flat and slides on at e > 0 rises flat, at e times its fall")
{
    flying::Random random(724);
    double worst = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const double w = random.uniform(0.5, 2.0);
        const double h = random.uniform(0.05, 1.0) * w;
        const double mu = random.uniform(0.0, 0.9);
        const double e = random.uniform();
        const ImpactResult after = strike(k_wall, box(1.0, w, h, {2.0, -1.0}, 0.0), floor_points(w, h), {e, mu});
        const double left = 2.0 - mu * (1.0 + e);
        if (left < 0.0) continue;
        worst = std::max({worst, std::abs(after.velocity_b.x() - left), std::abs(after.velocity_b.y() - e),
                          std::abs(after.spin_b) * w});
    }
    CHECK(worst < 128.0 * k_epsilon);
}

TEST_CASE(
    "a thin plate that lands flat loses mu (1+e) times its fall of its slide, is stopped by it, and never turned back")
{
    flying::Random random(731);
    double worst = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const double w = random.uniform(0.5, 2.0);
        const double slide = random.uniform(-2.0, 2.0);
        const Material material{random.uniform(), random.uniform(0.0, 1.0)};
        const ImpactResult after = strike(k_wall, box(1.0, w, 0.0, {slide, -1.0}, 0.0), floor_points(w, 0.0), material);
        const double left = std::max(0.0, std::abs(slide) - material.friction * (1.0 + material.restitution));
        worst = std::max({worst, std::abs(after.velocity_b.x() - std::copysign(left, slide)),
                          std::abs(after.velocity_b.y() - material.restitution), std::abs(after.spin_b) * w});
    }
    CHECK(worst < 32.0 * k_epsilon);
}

TEST_CASE("a rocking block that falls on its other corner keeps 1 - 1.5 sin^2 a of its spin")
{
    // It turns about one corner and lands on the other, e = 0, friction enough to hold: the first corner lifts freely
    for (const double a : {0.1, 0.3, 0.5}) {
        const double w = std::sin(a);
        const double h = std::cos(a);
        const double omega = -0.8; // about the right corner: r = (w, -h), v = -omega x r; the left one lies at rest
        const Points points = floor_points(w, h);
        const Vec2 about_left = -flying::cross(omega, points[0].r_b);
        const ImpactResult after = strike(k_wall, box(1.0, w, h, about_left, omega), points, {0.0, 10.0});
        CHECK(after.ended);
        CHECK(std::abs(after.spin_b / omega - (1.0 - 1.5 * w * w)) < 32.0 * k_epsilon);
        CHECK((after.velocity_b + flying::cross(after.spin_b, points[1].r_b)).norm() < 32.0 * k_epsilon);
    }
}

// ---- Anything -------------------------------------------------------------------------------------------------------

TEST_CASE("struck at several points at once, no pair gains energy and no point is left approaching")
{
    flying::Random random(725);
    double worst_gain = 0.0;
    double worst_left = 0.0;
    int pushes = 0;
    for (int i = 0; i < 60'000; ++i) {
        const Pair pair = random_pair(random, i % 2 == 0 ? 3.0 : 1e4);
        const Points points = random_points(random, 5, 3);
        const Material material{random.below(4) == 0 ? 1.0 : random.uniform(),
                                random.below(3) == 0 ? 0.0 : spread(random, 0.01, 3.0)};
        const ImpactResult after = strike(pair.a, pair.b, points, material);
        CHECK_UNARY(after.ended);
        if (!after.any_push) {
            CHECK_UNARY(same_bits(after, {pair.a.velocity, pair.b.velocity, pair.a.spin, pair.b.spin, false, true}));
            continue;
        }
        ++pushes;
        const real before = energy(pair.a, pair.b);
        worst_gain = std::max(worst_gain, static_cast<double>((energy(pair.a, pair.b, after) - before) / before));
        worst_left = std::max(worst_left, worst_approach(pair.a, pair.b, points, after));
    }
    CHECK(pushes > 40'000);
    CHECK(worst_gain < 64.0 * k_epsilon);
    CHECK(worst_left < 96.0 * k_epsilon); // the tolerance is on the sum over both axes and all points
}

TEST_CASE("struck at several points at e = 1 without friction, energy is kept to rounding")
{
    // Normals that face each other may lock two bodies, a peg in its hole: no rebound ends that, so it is stopped. Left
    // out here: cosines below -0.5
    flying::Random random(726);
    double worst = 0.0;
    for (int i = 0; i < 60'000; ++i) {
        const Pair pair = random_pair(random, 10.0);
        const Points points = random_points(random, 4, 2);
        const auto faces = [&](const ImpactPoint& point) { return point.normal.dot(points[0].normal) < -0.5; };
        if (std::ranges::any_of(points, faces)) continue;
        const ImpactResult after = strike(pair.a, pair.b, points, {1.0, 0.0});
        CHECK_UNARY(after.ended);
        const real before = energy(pair.a, pair.b);
        worst = std::max(worst, static_cast<double>(std::abs(energy(pair.a, pair.b, after) - before) / before));
    }
    CHECK(worst < 256.0 * k_epsilon);
}

TEST_CASE("the order of the points, and a point given twice, change the answer by rounding only")
{
    flying::Random random(727);
    double worst = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const Pair pair = random_pair(random, 10.0);
        Points points = random_points(random, 3, 2);
        const Material material{random.uniform(), 0.0};
        const ImpactResult first = strike(pair.a, pair.b, points, material);
        std::reverse(points.begin(), points.end());
        points.push_back(points.front());
        const ImpactResult second = strike(pair.a, pair.b, points, material);
        worst = std::max({worst, (first.velocity_a - second.velocity_a).norm(),
                          (first.velocity_b - second.velocity_b).norm(), std::abs(first.spin_a - second.spin_a),
                          std::abs(first.spin_b - second.spin_b)});
    }
    CHECK(worst < 1e-9);
}

TEST_CASE("swapping A and B swaps the answer, to rounding")
{
    flying::Random random(728);
    double worst = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const Pair pair = random_pair(random, 10.0);
        const Points points = random_points(random, 2, 2);
        Points swapped;
        for (const ImpactPoint& point : points) swapped.push_back({point.r_b, point.r_a, -point.normal});
        const Material material{random.uniform(), random.uniform(0.0, 0.5)};
        const ImpactResult first = strike(pair.a, pair.b, points, material);
        const ImpactResult second = strike(pair.b, pair.a, swapped, material);
        worst = std::max(
            {worst, (first.velocity_a - second.velocity_b).norm(), (first.velocity_b - second.velocity_a).norm()});
    }
    CHECK(worst < 1e-9);
}

TEST_CASE("several points scale bit for bit by powers of two of masses, lengths and times")
{
    flying::Random random(729);
    for (int i = 0; i < 5'000; ++i) {
        const Pair pair = random_pair(random, 1e3);
        const Points points = random_points(random, 4, 2);
        const Material material{random.uniform(), random.below(2) == 0 ? 0.0 : random.uniform(0.0, 1.0)};
        const PowerScale scale = PowerScale::random(random);
        Points far;
        for (const ImpactPoint& point : points) far.push_back(scale.of(point));
        const ImpactResult plain = strike(pair.a, pair.b, points, material);
        const ImpactResult large = strike(scale.of(pair.a), scale.of(pair.b), far, material);
        CHECK(same_bits(large, scale.of(plain)));
    }
}

TEST_CASE("two points nearer than rounding can tell apart do what one does")
{
    flying::Random random(730);
    double worst = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const Pair pair = random_pair(random, 10.0);
        Points one = random_points(random, 2, 1);
        one.pop_back();
        Points two = one;
        two.push_back(one[0]);
        const Vec2 beside = spread(random, 1e-17, 1e-10) * flying::perp(one[0].normal);
        two[1].r_a += beside;
        two[1].r_b += beside;
        const Material material{random.uniform(), 0.0};
        const ImpactResult first = strike(pair.a, pair.b, one, material);
        const ImpactResult second = strike(pair.a, pair.b, two, material);
        CHECK(second.ended);
        worst = std::max(
            {worst, (first.velocity_a - second.velocity_a).norm(), (first.velocity_b - second.velocity_b).norm()});
    }
    CHECK(worst < 1e-8);
}

TEST_CASE("a needle's two corners with a heavy middle, which ask for many rounds, end without energy lost")
{
    // Mass in the middle: the corners' normals are nearly opposed in the metric of the masses
    for (const double moment : {1e-1, 1e-2, 1e-3}) {
        const Points points = floor_points(1.0, 0.0);
        const ImpactBody falling = body(1.0, moment, {0.0, -0.1}, 1.0);
        const ImpactResult after = strike(k_wall, falling, points, {1.0, 0.0});
        CHECK(after.ended);
        const real before = energy(k_wall, falling);
        CHECK(std::abs(static_cast<double>(energy(k_wall, falling, after) / before - 1.0L)) < 1e-13);
    }
}

TEST_CASE("a body locked between two points that face each other is stopped")
{
    const Points points{{{0.0, 0.0}, {-1.0, 0.0}, {1.0, 0.0}}, {{2.0, 0.0}, {1.0, 0.0}, {-1.0, 0.0}}};
    const ImpactResult after = strike(k_wall, body(1.0, 0.5, {-2.0, 3.0}, 0.0), points, {1.0, 0.0});
    CHECK(after.ended);
    CHECK(after.velocity_b == Vec2(0.0, 3.0));
}

TEST_CASE("a disc in a corner is thrown back along both walls at once")
{
    const Points points{{{0.0, 0.0}, {-1.0, 0.0}, {1.0, 0.0}}, {{0.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}}};
    const ImpactResult after = strike(k_wall, body(1.0, 0.5, {-2.0, -3.0}, 0.0), points, {1.0, 0.0});
    CHECK(after.velocity_b == Vec2(2.0, 3.0));
    CHECK(after.spin_b == 0.0);
}
