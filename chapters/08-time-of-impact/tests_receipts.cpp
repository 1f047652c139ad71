#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "bar.hpp"
#include "math/random.hpp"
#include "support/receipts.hpp"
#include "toi/central_flight.hpp"
#include "toi/relative_flight.hpp"
#include "two_flyers.hpp"
#include "wrong_step.hpp"
#include "wrong_steps.hpp"

using namespace flying;

// [toi.tests.bar]
TEST_CASE("a turning bar strikes the floor at the arc sine of its height")
{
    Random random(803);
    double worst = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const double y = random.uniform(0.1, 0.95);
        const double spin = random.uniform(0.1, 50.0);
        const Prediction answer = predict(bar(), turning_bar(y, spin), k_floor, {}, 0.0);
        REQUIRE(answer.kind == Prediction::Kind::impact);
        const double t = bar_strikes(y, spin);
        worst = std::max(worst, std::abs(read_corner(y, spin, answer.time).gap));

        // A few roundings of the height, over the speed at which the end comes down
        CHECK_EQUATION("toi.bar", answer.time, t, 1e-13, {"y", y}, {"r", k_arm}, {"\\alpha", k_lean},
                       {"\\omega", spin});
        CHECK_TWIN("toi.bar", answer.time, std::asin(y / k_arm) / spin, 1e-13);
    }
    CHECK(worst <= 4e-15);
    RECORD_VALUE("toi.bar.gap", worst);
}
// [toi.tests.bar]

TEST_CASE("a gap changes as fast as the vertex moves along the normal, seen from the edge")
{
    Random random(804);
    for (int i = 0; i < 1000; ++i) {
        const TwoFlyers two = random_two(random);
        const auto [n, u, w] = two.at_edge(0.0);
        const double rate = two.rate_by_differences(0.0);

        // Differences of fourth order over 1/512 s, where spins are below 3 rad/s
        const double closed = n.x() * (u.x() - w.x()) + n.y() * (u.y() - w.y());
        CHECK_EQUATION_SCALED("toi.rate", rate, closed, 10.0, 1e-9, {"n_1", n.x()}, {"n_2", n.y()}, {"u_1", u.x()},
                              {"u_2", u.y()}, {"w_1", w.x()}, {"w_2", w.y()});
        const Vec2 centre = two.q.velocity;
        const double twin = n.dot(u - centre); // as though the edge did not turn
        if (std::abs(twin - closed) > 1e-6) CHECK_TWIN_SCALED("toi.rate", rate, twin, 10.0, 1e-9);
    }
}

TEST_CASE("no gap bends more than its bound, and the worst of all flights bends just as much")
{
    Random random(805);
    for (int i = 0; i < 1000; ++i) {
        // All in line: the arm along the normal, the flight across it, each term of the same sign
        TwoFlyers two = random_two(random);
        const double L = two.p.position.norm();
        const double V = two.p.velocity.norm();
        const double A = two.acceleration.norm();
        const double r = two.vertex.norm();
        const double p = two.p.spin;
        const double q = -std::max(std::abs(two.q.spin), 0.2);
        two.q = {};
        two.q.angle = -0.5 * std::numbers::pi; // the edge's normal points along x
        two.q.spin = q;
        two.p.angle = 0.0;
        two.p.position = {L, 0.0};
        two.p.velocity = {0.0, V};
        two.acceleration = {-A, 0.0};
        two.vertex = {r, 0.0};

        // The bound has a margin of 1e-9; differences of fourth order find the true bend to 1e-6
        const double M = A + 2 * std::abs(q) * V + q * q * L + (p - q) * (p - q) * r;
        const double engine = two.bend_bound();
        CHECK_EQUATION("toi.bend", engine, M, 2e-9, {"A", A}, {"\\omega_p", p}, {"r", r}, {"\\omega_q", q}, {"V", V},
                       {"L", L});
        CHECK_TWIN("toi.bend", engine, M - std::abs(q) * V, 2e-9);
        CHECK(std::abs(two.bend_by_differences(0.0) + engine) <= 1e-6 * engine);
    }
    for (int i = 0; i < 20000; ++i) {
        const TwoFlyers two = random_two(random);
        CHECK(std::abs(two.bend_by_differences(0.0)) <= two.bend_bound() * (1.0 + 1e-6));
    }
}

TEST_CASE("a safe step is the first root of the parabola below")
{
    Random random(806);
    for (int i = 0; i < 1000; ++i) {
        const double f = random.uniform(0.001, 5.0);
        const double rate = random.uniform(-3.0, 3.0);
        const double M = random.uniform(0.1, 10.0);
        const double step = safe_step(f, rate, M);

        // Where f' > 0 the printed form is the one that cancels: by at most 9 / (2 M f) of twice the digits
        const long double wide = static_cast<long double>(rate);
        const long double root = std::sqrt(wide * wide + 2.0L * M * f);
        const double closed = static_cast<double>(2.0L * f / (root - wide));
        CHECK_EQUATION("toi.step", step, closed, 1e-14, {"f", f}, {"f'", rate}, {"M", M});
        CHECK_TWIN("toi.step", step, static_cast<double>(2.0L * f / (std::sqrt(wide * wide + M * f) - wide)), 1e-14);
    }
}

TEST_CASE("the noise of a gap counts the roundings of its coordinates and of its time")
{
    Random random(811);
    for (int i = 0; i < 1000; ++i) {
        const double X = random.uniform(0.0, 1e6);
        const double R = random.uniform(0.1, 10.0);
        const double W = random.uniform(0.0, 1e4);
        const double t = random.uniform(0.0, 1e3);
        const double delta = 4.0 * gap_tolerance(R, R, X, W, t).noise;
        const double e = tolerance::k_epsilon;
        CHECK_EQUATION("toi.noise", delta, e * (8 * (X + R) + 2 * W * t), 1e-15, {"\\varepsilon", e}, {"X", X},
                       {"R", R}, {"W", W}, {"t", t});
        CHECK_TWIN("toi.noise", delta, e * (6 * (X + R) + 2 * W * t), 1e-15);
    }
}

TEST_CASE("no gap of a turning vertex over a wall is farther off than the bound on its noise")
{
    Random random(813);
    constexpr int k_cases = 100'000;
    double worst = 0.0;
    for (int i = 0; i < k_cases; ++i) {
        const double height = random.uniform(0.0, 4.0) * std::exp2(20.0 * random.uniform());
        Flyer flyer = turning_bar(height, random.uniform(-10.0, 10.0));
        flyer.state.velocity = {0.0, random.uniform(-2.0, 2.0)};
        flyer.state.angle = random.uniform(-3.0, 3.0);
        const double t = random.uniform(0.0, 100.0);

        // As a march reads it, and in the longer numbers from the same states
        const Vec2 vertex(k_half_length, -k_half_thickness);
        const double offset = height - 0.5;
        const RelativeFlight relative = relative_flight(flyer, {}, 0.0);
        const Vec2 arm = Turning(flyer.state).at(t) * vertex;
        const double gap = relative.offset_at(t).y() - offset + arm.y();
        const long double angle =
            static_cast<long double>(flyer.state.angle) + static_cast<long double>(flyer.state.spin) * t;
        const long double exact = static_cast<long double>(height) +
                                  static_cast<long double>(flyer.state.velocity.y()) * t - offset +
                                  std::sin(angle) * vertex.x() + std::cos(angle) * vertex.y();
        const double speed = std::abs(flyer.state.velocity.y()) + std::abs(flyer.state.spin) * k_arm;
        const double reach = std::max(height, std::abs(relative.offset_at(t).y()));
        const double delta = 4.0 * gap_tolerance(k_arm, k_arm, reach, speed, t).noise;
        worst = std::max(worst, static_cast<double>(std::abs(gap - exact)) / delta);
    }
    CHECK(worst <= 1.0);
    CHECK(worst > 0.1); // a bound a hundred times too large would be none
    RECORD_VALUE("toi.noise.worst", 100.0 * worst);
    RECORD_VALUE("toi.noise.cases", k_cases);
}

TEST_CASE("where a vertex touches without approach, the march goes on by a step in which the gap hardly changes")
{
    Random random(807);
    for (int i = 0; i < 1000; ++i) {
        const double M = random.uniform(0.1, 100.0);
        const double slack = random.uniform(1e-16, 1e-9);
        const MarchBounds bounds{M, k_never, k_never, {slack, 0.25 * slack, 1e-15}};
        const double step = certain_step({0.0, 0.0, 0.0, 0.0}, bounds);
        CHECK_EQUATION("toi.graze", step, std::sqrt(slack / (2 * M)), 1e-15, {"\\sigma", slack}, {"M", M});
        CHECK_TWIN("toi.graze", step, std::sqrt(slack / M), 1e-15);
        CHECK(0.5 * M * step * step <= 0.2500001 * slack);
    }
}

TEST_CASE("a wave that dips below zero strikes and one that stays above does not, and on zero itself either may be said")
{
    const double noise = 1e-15;
    const MarchBounds bounds{1.0 + 1e-9, k_never, k_never, {1e-13, noise, 1e-15}};
    for (const double depth : {-1e-3, -1e-6, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-6, 1e-3}) {
        const auto wave = [&](double t) {
            const SineCosine at = sine_cosine(t);
            return EdgeReading{1.0 - depth + at.cosine, -at.sine, 0.0, 0.0};
        };
        const MarchEnd end = march(wave(0.0), wave, bounds, 0.0, 2.0 * std::numbers::pi);
        if (depth != 0.0) CHECK((end.kind == MarchEnd::Kind::strike) == (depth > 0.0));
        if (end.kind != MarchEnd::Kind::strike) continue;
        CHECK(std::abs(wave(end.time).gap) <= noise);

        // A strike that is none is as slow as a fall through the noise
        if (depth == 0.0) CHECK(std::abs(wave(end.time).gap_rate) <= std::sqrt(2.0 * noise) * 1.01);
    }
}

TEST_CASE("round a centre, the pull of the near future is that of half the distance, or of the nearest point")
{
    Random random(808);
    const CentralField field{{0.0, 0.0}, 4.0};
    int by_half = 0;
    int by_orbit = 0;
    for (int i = 0; i < 1000; ++i) {
        const double r_0 = random.uniform(1.0, 3.0);
        const double v_1 = random.uniform(-1.0, 1.0);
        const double v_2 = random.uniform(0.05, 2.0);
        Flyer flyer;
        flyer.state.position = {r_0, 0.0};
        flyer.state.velocity = {v_1, v_2};
        flyer.central = &field;
        const CentralPath path(flyer, field);
        const CentralPath::Outlook outlook = path.outlook(flyer.state.position, 0.0);

        // The nearest point of the orbit, from its energy and its angular momentum
        const double l = r_0 * v_2;
        const double energy = 0.5 * (v_1 * v_1 + v_2 * v_2) - 4.0 / r_0;
        const double r_1 = l * l / (4.0 * (1.0 + std::sqrt(1.0 + 2.0 * energy * l * l / 16.0)));
        const double nearest = std::max(0.5 * r_0, r_1);
        CHECK_EQUATION("toi.pull", outlook.acceleration, 4.0 / (nearest * nearest), 1e-9, {"\\mu", 4.0}, {"r_0", r_0},
                       {"r_1", r_1});
        CHECK_TWIN("toi.pull", outlook.acceleration, 4.0 / nearest, 1e-9);
        if (r_1 > 0.5 * r_0) {
            ++by_orbit;
            CHECK(outlook.until == k_never);
            continue;
        }
        ++by_half;
        const double v = std::sqrt(v_1 * v_1 + v_2 * v_2);
        const double until = r_0 / (2 * std::sqrt(v * v + 2 * 4.0 / r_0));
        CHECK_EQUATION("toi.half", outlook.until, until, 2e-12, {"r_0", r_0}, {"v", v}, {"\\mu", 4.0});
        CHECK_TWIN("toi.half", outlook.until, r_0 / (2 * v), 2e-12);
        CHECK(path.at(outlook.until).position.norm() >= 0.5 * r_0);
    }
    CHECK(by_half > 100);
    CHECK(by_orbit > 100);
}

TEST_CASE("the same meeting a million seconds later is found a million seconds later")
{
    Random random(812);
    constexpr double k_later = 0x1p20;
    double worst = 0.0;
    int meetings = 0;
    for (int i = 0; i < 500; ++i) {
        Flyer a;
        a.state.position = {-3.0, random.uniform(-0.5, 0.5)};
        a.state.velocity = {random.uniform(1.0, 3.0), 0.0};
        a.state.spin = random.uniform(-0.5, 0.5);
        Flyer b;
        b.state.position = {3.0, 0.0};
        b.state.velocity = {random.uniform(-3.0, -1.0), 0.0};
        b.state.spin = random.uniform(-0.5, 0.5);
        b.state.angle = random.uniform(-3.0, 3.0);
        const double plain = predict(bar(), a, bar(), b, 0.0, {.windows = 1000}).time;
        a.state.time = k_later;
        b.state.time = k_later;
        const double late = predict(bar(), a, bar(), b, k_later, {.windows = 1000}).time;
        CHECK((plain < k_never) == (late < k_never));
        if (plain == k_never) continue;

        // How fast the gap closes: where it hardly does, its noise is worth any time
        const auto gap = [&](double since) {
            const double time = k_later + plain - since;
            return separation(bar(), pose_of(state_at(a, time)), bar(), pose_of(state_at(b, time)));
        };
        if (gap(1.0 / 4096) < 0.5 / 4096) continue;
        ++meetings;
        worst = std::max(worst, std::abs(late - k_later - plain));
    }
    CHECK(meetings > 200);

    // The noise of a gap at 2^20 s, for speeds below 4 m/s, over half a metre per second
    CHECK(worst <= 2.0 * gap_tolerance(1.0, 1.0, 8.0, 4.0, k_later).noise);
    RECORD_VALUE("toi.late.off", worst);
}

TEST_CASE("a disc that falls straight in strikes the disc at the centre at the time of the closed form")
{
    // sqrt(r^3 / 2 mu) (acos sqrt q + sqrt(q (1 - q))), where q = 1/4 is the share of the way that is left
    const CentralField field{{0.0, 0.0}, 2.0};
    Flyer falling;
    falling.state.position = {4.0, 0.0};
    falling.central = &field;
    Prediction answer = predict(Disc{0.5}, falling, Disc{0.5}, {}, 0.0);
    while (answer.kind == Prediction::Kind::not_before)
        answer = predict(Disc{0.5}, falling, Disc{0.5}, {}, answer.time);
    REQUIRE(answer.kind == Prediction::Kind::impact);
    const double expected = 4.0 * (std::numbers::pi / 3 + std::sqrt(3.0) / 4);
    CHECK(std::abs(answer.time - expected) <= 1e-14 * expected);
}

// [toi.tests.wrong_steps]
TEST_CASE("a disc that is looked at step by step passes a thin wall "
          "as often as the steps are too long")
{
    const double step = 1.0 / 60.0;
    const double seen_from = k_wall_thickness + 2 * k_disc_radius;
    RECORD_VALUE("toi.wall.slowest", seen_from / step);
    for (const double V : {8.0, 10.0, 60.0, 300.0}) {
        int seen = 0;
        constexpr int k_throws = 2000;
        // [toi.tests.wrong_steps.throws]
        for (int k = 0; k < k_throws; ++k) {
            const Flyer flyer = thrown(-1.0 - V * step * k / k_throws, V);
            seen += first_overlap(flyer, step, 2.0 / V + 3 * step) < k_never ? 1 : 0;
            const Prediction answer = predict(Disc{k_disc_radius}, flyer, thin_wall(), {}, 0.0, {.windows = 1000});
            CHECK(answer.kind == Prediction::Kind::impact);
        }
        // [toi.tests.wrong_steps.throws]
        const double share = static_cast<double>(seen) / k_throws;
        CHECK_EQUATION("toi.seen", share, seen_from / (V * step), 1e-2, {"w", k_wall_thickness}, {"R", k_disc_radius},
                       {"V", V}, {"\\Delta", step});
        CHECK_TWIN("toi.seen", share, k_wall_thickness / (V * step), 1e-2);
        CHECK(seen < k_throws); // the wall is passed: this finds it
    }
}
// [toi.tests.wrong_steps]

// [toi.tests.wrong_step]
TEST_CASE("the safe step by the school formula passes roots, or does not move at all")
{
    Random random(810);
    int passed = 0;
    int stuck = 0;
    for (int i = 0; i < 1000; ++i) {
        const double f = std::pow(10.0, random.uniform(-15.0, -3.0));
        const double bend = std::pow(10.0, random.uniform(-6.0, 0.0));

        // The worst that the bound allows is the parabola; here is its root by long double
        const double root = static_cast<double>(2.0L * f / (1.0L + std::sqrt(1.0L + 2.0L * bend * f)));
        CHECK(safe_step(f, -1.0, bend) <= root * (1.0 + 4e-16));
        const double wrong = school_step(f, -1.0, bend);
        passed += wrong > root * (1.0 + 1e-9) ? 1 : 0;
        stuck += wrong == 0.0 ? 1 : 0;
    }
    CHECK(passed > 100);
    CHECK(stuck > 100);
}
// [toi.tests.wrong_step]
