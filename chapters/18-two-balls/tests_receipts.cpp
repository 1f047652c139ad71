#include <cmath>
#include <limits>
#include <numbers>

#include <doctest/doctest.h>

#include "billiard.hpp"
#include "few.hpp"
#include "math/random.hpp"
#include "response/newton.hpp"
#include "spring.hpp"
#include "support/receipts.hpp"
#include "toi/discs.hpp"
#include "wrong_quadratic.hpp"

using namespace flying;

namespace {

constexpr double k_pi = std::numbers::pi;
constexpr double k_epsilon = std::numeric_limits<double>::epsilon();

/// Two discs that touch, in any direction, and approach.
struct Pair
{
    discs::Disc a;
    discs::Disc b;
    Vec2 n;     ///< from A to B
    double v_n; ///< of B seen from A, along n [m/s]
};

double speed_along(const discs::Disc& a, const discs::Disc& b, const Vec2& n)
{
    return (b.vx - a.vx) * n.x() + (b.vy - a.vy) * n.y();
}

Pair random_pair(Random& random)
{
    for (;;) {
        const auto disc = [&] {
            const double vx = random.uniform(-3.0, 3.0);
            const double vy = random.uniform(-3.0, 3.0);
            const double r = random.uniform(0.5, 1.0);
            return discs::Disc{0.0, 0.0, vx, vy, r, std::exp(random.uniform(-1.5, 1.5))};
        };
        Pair pair{disc(), disc(), {}, 0.0};
        const SineCosine way = sine_cosine(random.uniform(0.0, 2.0 * k_pi));
        pair.n = {way.cosine, way.sine};
        pair.b.x = (pair.a.r + pair.b.r) * pair.n.x();
        pair.b.y = (pair.a.r + pair.b.r) * pair.n.y();
        pair.v_n = speed_along(pair.a, pair.b, pair.n);
        if (pair.v_n < -0.5) return pair;
    }
}

/// Where the billiard's motion lies on its circle: sqrt(M) V to the right, sqrt(m) v
/// upwards.  [rad]
double angle_of(const discs::Room& room, double ratio)
{
    return std::atan2(room.discs[0].vx, std::sqrt(ratio) * room.discs[1].vx);
}

/// Everything up to the next impact; false where none is left.
bool advance_one_impact(discs::Room& room)
{
    const discs::Impact next = discs::first_impact(room);
    if (next.wait == discs::k_never) return false;
    discs::fly(room, next.wait);
    discs::happen(room, next);
    return true;
}

} // namespace

TEST_CASE("two discs meet at the smaller root of their quadratic")
{
    Random random(801);
    for (int i = 0; i < 1000; ++i) {
        const double s = random.uniform(0.5, 2.0);
        const double distance = random.uniform(3.0, 30.0);
        const FarPair pair = far_pair(distance, random.uniform(0.0, 0.9) * s);
        const double b = -pair.x.dot(pair.v);
        const double c = pair.x.squaredNorm() - s * s;
        const double D = b * b - pair.v.squaredNorm() * c;
        const double t = time_to_meet(pair.x, pair.v, s);
        CHECK_EQUATION("toi.discs", t, exactly(pair, s), 4e-15, {"c", c}, {"b", b},
                       {"D", D});
        CHECK_TWIN("toi.discs", t, c / (b - std::sqrt(D)), 4e-15);

        // The page's own function and the engine's are one formula
        const discs::Disc a{pair.x.x(), pair.x.y(), pair.v.x(), pair.v.y(), 0.5 * s, 1.0};
        CHECK(discs::when_meet(a, {0.0, 0.0, 0.0, 0.0, 0.5 * s, 1.0}) == t);
    }
}

TEST_CASE("a disc falls on a wall when its parabola does")
{
    Random random(802);
    for (int i = 0; i < 1000; ++i) {
        const double h = random.uniform(0.0, 9.0);
        const double u = random.uniform(-9.0, 0.0);
        const double a = random.uniform(-9.0, 0.0);
        const double t = time_to_fall(h, u, a);
        CHECK_EQUATION("toi.fall", t, 2 * h / (std::sqrt(u * u - 2 * a * h) - u), 2e-15,
                       {"h", h}, {"u", u}, {"a", a});
        CHECK_TWIN("toi.fall", t, 2 * h / (std::sqrt(u * u - a * h) - u), 2e-15);

        // There the height is zero, in the longer numbers
        const long double wide = t;
        const long double height = h + u * wide + 0.5L * a * wide * wide;
        CHECK(std::abs(static_cast<double>(height)) <= 64.0 * k_epsilon * (1.0 + h));
    }
}

TEST_CASE("two discs part e times as fast as they met, and keep their momentum")
{
    Random random(1801);
    for (int i = 0; i < 2000; ++i) {
        const Pair before = random_pair(random);
        const double e = random.uniform();
        Pair after = before;
        discs::strike(after.a, after.b, e);
        const double v_n = speed_along(after.a, after.b, before.n);
        CHECK_EQUATION_SCALED("impulse.newton", v_n, -e * before.v_n, 10.0, 4e-15, {"e", e},
                              {"v_n", before.v_n});
        CHECK_TWIN_SCALED("impulse.newton", v_n, -e * e * before.v_n, 10.0, 4e-15);
        const double left = before.a.m * before.a.vx + before.b.m * before.b.vx;
        const double kept = after.a.m * after.a.vx + after.b.m * after.b.vx;
        CHECK(std::abs(kept - left) <= 1e-14 * (before.a.m + before.b.m) * 10.0);

        // The engine's function gives this very push
        const double w_n = 1.0 / before.a.m + 1.0 / before.b.m;
        const double j = newton_impulse(before.v_n, w_n, e);
        CHECK(std::abs(after.b.vx - before.b.vx - j / before.b.m * before.n.x()) <= 1e-14);
    }
}

// [discs.tests.spring]
TEST_CASE("a stiff spring between two discs pushes them apart as the formula says")
{
    Random random(1802);
    for (int i = 0; i < 100; ++i) {
        const Pair before = random_pair(random);
        const double e = random.uniform(0.1, 1.0);
        Pair after = before;
        strike_with_spring(after.a, after.b, e, 1e11, 1e-8);
        const double j =
            before.b.m * std::hypot(after.b.vx - before.b.vx, after.b.vy - before.b.vy);
        const double w_n = 1.0 / before.a.m + 1.0 / before.b.m;
        CHECK_EQUATION("discs.push", j, -(1 + e) * before.v_n / w_n, 1e-3, {"e", e},
                       {"v_n", before.v_n}, {"m_a", before.a.m}, {"m_b", before.b.m});
        CHECK_TWIN("discs.push", j, -(1 + e) * before.v_n / (w_n + 1.0 / before.b.m), 1e-3);
    }
}
// [discs.tests.spring]

TEST_CASE("equal discs part at a right angle if one of them was at rest")
{
    Random random(1803);
    for (int i = 0; i < 1000; ++i) {
        Pair pair = random_pair(random);
        pair.b.vx = 0.0;
        pair.b.vy = 0.0;
        pair.b.m = pair.a.m;
        if (speed_along(pair.a, pair.b, pair.n) > -0.5) continue;
        discs::strike(pair.a, pair.b, 1.0);
        const double along_y = pair.a.vy * pair.b.vy;
        CHECK_EQUATION_SCALED("discs.right_angle", pair.a.vx * pair.b.vx, -along_y, 10.0,
                              4e-15, {"v_{ay}'", pair.a.vy}, {"v_{by}'", pair.b.vy});
        CHECK_TWIN_SCALED("discs.right_angle", pair.a.vx * pair.b.vx, 0.1 - along_y, 10.0,
                          4e-15);
    }
}

TEST_CASE("the second of three balls is struck before it was foreseen to strike")
{
    Random random(1010);
    for (int i = 0; i < 200; ++i) {
        const double v = random.uniform(0.5, 2.0);
        const double w = random.uniform(0.2, 2.0);
        const double g_1 = random.uniform(0.5, 3.0);
        const double g_2 = g_1 * w / v + random.uniform(0.1, 3.0); // so that A comes first
        Few few;
        few.discs = {{{-1.0 - g_1, 0.0, v, 0.0, 0.5, 1.0}},
                     {{0.0, 0.0, 0.0, 0.0, 0.5, 1.0}},
                     {{1.0 + g_2, 0.0, -w, 0.0, 0.5, 1.0}}};
        few.run(1e3);
        REQUIRE(few.handled.size() >= 2);
        CHECK(few.handled[0].time == doctest::Approx(g_1 / v).epsilon(1e-14));
        CHECK_EQUATION("events.second", few.handled[1].time, (g_1 + g_2) / (v + w),
                       16.0 * k_epsilon, {"g_1", g_1}, {"g_2", g_2}, {"v", v}, {"w", w});
        CHECK_TWIN("events.second", few.handled[1].time, g_2 / w, 16.0 * k_epsilon);
    }
}

TEST_CASE("on its circle the billiard is mirrored by the wall, and turned by each blow")
{
    for (const double ratio : {1.0, 3.7, 16.0, 100.0, 1e4}) {
        discs::Room room = billiard_room(ratio);
        const double theta = billiard_angle(ratio);
        double before = angle_of(room, ratio);
        for (bool is_blow = true; advance_one_impact(room); is_blow = !is_blow) {
            const double m = 1.0;
            const double v = room.discs[0].vx;
            const double heavy = room.discs[1].vx;
            CHECK_EQUATION("events.circle", ratio * heavy * heavy + m * v * v, ratio, 1e-13,
                           {"M", ratio}, {"V_0", 1.0});
            CHECK_TWIN("events.circle", heavy * heavy + v * v + 0.1, ratio, 1e-13);

            const double after = angle_of(room, ratio);
            if (is_blow) {
                CHECK_EQUATION_SCALED("events.blow", after, 2 * theta - before, 1.0, 1e-13,
                                      {"\\varphi", before}, {"\\theta", theta});
                CHECK_TWIN_SCALED("events.blow", after, theta - before, 1.0, 1e-13);
            } else {
                CHECK_EQUATION_SCALED("events.wall", after, -before, 1.0, 1e-13,
                                      {"\\varphi", before});
                CHECK_TWIN_SCALED("events.wall", after, theta - before, 1.0, 1e-13);
            }
            before = after;
        }
    }
}

TEST_CASE("the billiard counts every n with n theta below pi, "
          "and ends where the circle says")
{
    Random random(1011);
    for (int i = 0; i < 500; ++i) {
        const double ratio = std::exp(random.uniform(0.0, 9.0));
        const double theta = billiard_angle(ratio);
        const double steps = k_pi / theta;
        if (std::abs(steps - std::round(steps)) < 1e-9)
            continue; // a tie, which rounding decides
        discs::Room room = billiard_room(ratio);
        const double n = static_cast<double>(discs::run(room, 1e5));
        CHECK_EQUATION("events.count", n, std::ceil(k_pi / theta) - 1, 0.0,
                       {"\\theta", theta});
        CHECK_TWIN("events.count", n, std::ceil(k_pi / theta), 0.0);

        const double even = 2.0 * std::ceil(n / 2.0);
        const double after = room.discs[1].vx;
        CHECK_EQUATION_SCALED("events.heavy_after", after, -std::cos(even * theta), 1.0,
                              1e-12, {"V_0", 1.0}, {"n", even}, {"\\theta", theta});
        CHECK_TWIN_SCALED("events.heavy_after", after, -std::cos((even + 1) * theta), 1.0,
                          1e-12);
    }
}
