#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "collide/separation.hpp"
#include "geometry/polygon.hpp"
#include "math/random.hpp"
#include "motion/flight.hpp"
#include "support/effort.hpp"
#include "support/flying_pairs.hpp"
#include "toi/predict.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("two discs meet when the quadratic says so, to rounding, from near and from far")
{
    for (const double distance : {3.0, 1e3, 1e6, 1e9}) {
        Flyer a;
        Flyer b;
        a.state.velocity = {1.0, 0.0};
        b.state.position = {distance, 0.75};
        // Centres 1.25 apart at the impact, 0.75 of it sideways: one metre is left along the path
        const Prediction answer = predict(Disc{0.5}, a, Disc{0.75}, b, 0.0);
        REQUIRE(answer.kind == Prediction::Kind::impact);
        CHECK(std::abs(answer.time - (distance - 1.0)) <= 4e-16 * distance);
    }
}

TEST_CASE("a glancing pair of discs keeps its digits")
{
    // Sideways distance h just below the sum of the radii s: they meet at x = sqrt((s - h)(s + h)) before the closest point
    for (const double miss : {1e-4, 1e-8, 1e-12}) {
        const double s = 2.0;
        const double h = s - miss;
        Flyer a;
        Flyer b;
        a.state.velocity = {1.0, 0.0};
        b.state.position = {5.0, h};
        const Prediction answer = predict(Disc{1.0}, a, Disc{1.0}, b, 0.0);
        REQUIRE(answer.kind == Prediction::Kind::impact);
        const double expected = 5.0 - std::sqrt((s - h) * (s + h));
        // h itself carries half an ulp of 2, which the square root stretches
        CHECK(std::abs(answer.time - expected) <= 4e-16 * s / std::sqrt(miss) + 1e-15);
    }
}

TEST_CASE("discs that part, pass, or stand still never meet")
{
    Flyer a;
    Flyer b;
    b.state.position = {2.0, 0.0};
    CHECK(predict(Disc{1.0}, a, Disc{1.0}, b, 0.0).kind == Prediction::Kind::never);
    b.state.velocity = {1e-9, 0.0};
    CHECK(predict(Disc{1.0}, a, Disc{1.0}, b, 0.0).kind == Prediction::Kind::never);
    b.state.position = {4.0, 2.1};
    b.state.velocity = {-1.0, 0.0};
    CHECK(predict(Disc{1.0}, a, Disc{1.0}, b, 0.0).kind == Prediction::Kind::never);
}

TEST_CASE("a falling disc meets the floor, and a thrown one comes back to it, when the parabola says so")
{
    Flyer a;
    a.acceleration = {0.0, -10.0};
    a.state.position = {0.0, 5.5};
    const HalfPlane floor{{0.0, 1.0}, 0.0};
    Prediction answer = predict(Disc{0.5}, a, floor, {}, 0.0);
    REQUIRE(answer.kind == Prediction::Kind::impact);
    CHECK(std::abs(answer.time - 1.0) <= 2.3e-16);

    // On the floor, thrown up at 3 m/s: back after 2 v / g
    a.state.position = {0.0, 0.5};
    a.state.velocity = {1.0, 3.0};
    answer = predict(Disc{0.5}, a, floor, {}, 0.0);
    REQUIRE(answer.kind == Prediction::Kind::impact);
    CHECK(std::abs(answer.time - 0.6) <= 2.3e-16);
}

TEST_CASE("the end of a spinning bar strikes a wall at the root of its equation")
{
    // A thin bar of half length 1 and half thickness 0.01 turns in place at 0.9 above the wall: its lower right corner
    // is at height 0.9 + sin(t) (-1 ...): corner (1, -0.01) turned by -t has height 0.9 - sin t - 0.01 cos t
    const Polygon bar = box(2.0, 0.02);
    Flyer a;
    a.state.position = {0.0, 0.9};
    a.state.spin = -1.0;
    const Prediction answer = predict(bar, a, HalfPlane{{0.0, 1.0}, 0.0}, {}, 0.0);
    REQUIRE(answer.kind == Prediction::Kind::impact);
    const double expected = std::asin(0.9 / std::hypot(1.0, 0.01)) - std::atan2(0.01, 1.0);
    CHECK(std::abs(answer.time - expected) <= 1e-15);
    CHECK(std::abs(answer.time - expected) / expected <= 1e-12);
}

TEST_CASE("a spinning square comes down on a wall corner first, at the root of its transcendental equation")
{
    // Height of the lowest corner: y - v t - r sin(w t + phase); solved here by bisection in long double
    const Polygon square = box(1.0, 1.0);
    const HalfPlane floor{{0.0, 1.0}, 0.0};
    Random random(20260101);
    double worst = 0.0;
    for (int k = 0; k < 200; ++k) {
        Flyer a;
        a.state.position = {0.0, random.uniform(1.0, 3.0)};
        a.state.velocity = {random.uniform(-1.0, 1.0), random.uniform(-4.0, -0.5)};
        a.state.spin = random.uniform(-20.0, 20.0);
        a.state.angle = random.uniform(-3.0, 3.0);
        const Prediction answer = predict_until(square, a, floor, {}, 100.0);
        REQUIRE(answer.kind == Prediction::Kind::impact);

        const auto lowest = [&](long double t) {
            long double low = 10.0L;
            for (int corner = 0; corner < 4; ++corner) {
                const long double phase = static_cast<long double>(k_pi) * (0.25L + 0.5L * corner) +
                                          static_cast<long double>(a.state.angle) + static_cast<long double>(a.state.spin) * t;
                low = std::min(low, static_cast<long double>(a.state.position.y()) +
                                        static_cast<long double>(a.state.velocity.y()) * t +
                                        std::sqrt(0.5L) * std::sin(phase));
            }
            return low;
        };
        // First sign change on a fine grid, then bisection
        long double low = 0.0L;
        while (lowest(low + 1e-4L) > 0.0L) low += 1e-4L;
        long double high = low + 1e-4L;
        for (int n = 0; n < 60; ++n) {
            const long double middle = 0.5L * (low + high);
            (lowest(middle) > 0.0L ? low : high) = middle;
        }
        // A gap of one rounding over the speed of approach
        worst = std::max(worst, std::abs(lowest(answer.time)) > 1e-15L ? static_cast<double>(std::abs(answer.time - low)) : 0.0);
        CHECK(std::abs(static_cast<double>(lowest(answer.time))) <= 4e-15);
    }
    CHECK(worst <= 1e-12);
}

TEST_CASE("two aligned squares meet head-on, face to face")
{
    Flyer a;
    Flyer b;
    a.state.position = {-2.0, 0.0};
    a.state.velocity = {1.0, 0.0};
    b.state.position = {2.0, 0.0};
    b.state.velocity = {-1.0, 0.0};
    const Prediction answer = predict(box(1.0, 1.0), a, box(1.0, 1.0), b, 0.0);
    REQUIRE(answer.kind == Prediction::Kind::impact);
    CHECK(std::abs(answer.time - 1.5) <= 1e-15);
}

TEST_CASE("squares that meet corner to corner are not missed")
{
    Flyer a;
    Flyer b;
    a.state = {{-3.0, 0.0}, {1.0, 0.0}, 0.25 * k_pi, 0.0, 0.0};
    b.state = {{3.0, 0.0}, {-1.0, 0.0}, 0.25 * k_pi, 0.0, 0.0};
    const Prediction answer = predict(box(1.0, 1.0), a, box(1.0, 1.0), b, 0.0);
    REQUIRE(answer.kind == Prediction::Kind::impact);
    CHECK(std::abs(answer.time - (3.0 - std::sqrt(0.5))) <= 1e-14);
}

TEST_CASE("a body that just left is not met again, unless it comes back")
{
    // Touching the wall with its face, moving away
    Flyer a;
    a.state.position = {0.0, 0.5};
    a.state.velocity = {0.3, 1.0};
    const HalfPlane floor{{0.0, 1.0}, 0.0};
    CHECK(predict_until(box(1.0, 1.0), a, floor, {}, 1e3).kind != Prediction::Kind::impact);

    // Under gravity it falls back after 2 v / g
    a.acceleration = {0.0, -2.0};
    const Prediction answer = predict_until(box(1.0, 1.0), a, floor, {}, 1e3);
    REQUIRE(answer.kind == Prediction::Kind::impact);
    CHECK(std::abs(answer.time - 1.0) <= 1e-13);
}

TEST_CASE("nothing passes a wall of a billionth of a body at a million sizes a second, nor at a million radians")
{
    const Polygon wall = box(1e-9, 10.0);
    Flyer still;
    for (const double spin : {0.0, 3.0, 1e6}) {
        Flyer a;
        a.state.position = {-1000.0, 0.123};
        a.state.velocity = {1e6, 0.0};
        a.state.spin = spin;
        const Prediction answer = predict_until(box(1.0, 0.5), a, wall, still, 1.0);
        REQUIRE(answer.kind == Prediction::Kind::impact);
        CHECK(answer.time <= 1000.0 / 1e6);
        CHECK(std::abs(gap_at(box(1.0, 0.5), a, wall, still, answer.time)) <= 1e-9);
        const Prediction disc = predict_until(Disc{0.5}, a, wall, still, 1.0);
        REQUIRE(disc.kind == Prediction::Kind::impact);
        CHECK(std::abs(disc.time - (1000.0 - 0.5 - 5e-10) / 1e6) <= 1e-18 * 1e3);
    }
}

TEST_CASE("asking in pieces, and looking before the circles meet, changes no bit")
{
    Random random(8);
    for (int k = 0; k < tried(400); ++k) {
        const Shape a = random_shape(random);
        const Shape b = random_shape(random);
        Flyer fa = random_flyer(random, Vec2(-2.2, random.uniform(-1.0, 1.0)));
        Flyer fb = random_flyer(random, Vec2(2.2, random.uniform(-1.0, 1.0)));
        if (k % 3 == 0) {
            fb = Flyer{};
            fb.state.position = {2.2, 0.0};
            fa.acceleration = {0.0, -3.0};
        }
        const Prediction whole = predict_until(a, fa, b, fb, 4.0, {.windows = 100000});
        const Prediction pieces = predict_until(a, fa, b, fb, 4.0, {.windows = 1});
        const Prediction looking = predict_until(a, fa, b, fb, 4.0, {.skips_far_features = false});
        if (whole.kind != Prediction::Kind::impact || whole.time >= 4.0) continue;
        INFO("case " << k);
        REQUIRE(pieces.kind == Prediction::Kind::impact);
        CHECK(pieces.time == whole.time);
        CHECK(looking.time == whole.time);
        CHECK(pieces.feature == whole.feature);
        CHECK(looking.feature == whole.feature);
    }
}

TEST_CASE("a pair that is put off strikes no earlier, and with no horizon or all of its vertices gives the same bits")
{
    Random random(10);
    int put_off = 0;
    for (int k = 0; k < tried(2000); ++k) {
        const Polygon a = star(random, 5, 0.4);
        const Polygon b = box(random.uniform(0.2, 2.0), random.uniform(0.2, 2.0));
        const Flyer fa = random_flyer(random, Vec2(-1.6, random.uniform(-1.0, 1.0)));
        const Flyer fb = random_flyer(random, Vec2(1.6, random.uniform(-1.0, 1.0)));
        const double start = common_start(fa, fb);
        const double horizon = start + random.uniform(0.0, 1.0);
        const Prediction whole = predict(a, fa, b, fb, start, {.windows = 100000});
        const Prediction all = predict(a, fa, b, fb, start, {.windows = 100000, .skips_far_vertices = false});
        const Prediction cut = predict(a, fa, b, fb, start, {.windows = 100000, .horizon = horizon});
        INFO("case " << k);
        CHECK(all.kind == whole.kind);
        CHECK(all.time == whole.time);
        CHECK(all.feature == whole.feature);
        if (cut.kind == Prediction::Kind::put_off) {
            ++put_off;
            CHECK(cut.time == horizon);
            CHECK(whole.time >= horizon);
        } else {
            CHECK(cut.kind == whole.kind);
            CHECK(cut.time == whole.time);
            CHECK(cut.feature == whole.feature);
        }
    }
    CHECK(put_off > 0);
}

TEST_CASE("lengths, times and masses by powers of two scale a prediction bit for bit")
{
    Random random(9);
    for (int k = 0; k < 200; ++k) {
        const Polygon a = star(random, 5, 0.4);
        const double width = random.uniform(0.2, 2.0);
        const Polygon b = box(width, random.uniform(0.2, 2.0));
        const Flyer fa = random_flyer(random, Vec2(-2.2, random.uniform(-1.0, 1.0)));
        const Flyer fb = random_flyer(random, Vec2(2.2, random.uniform(-1.0, 1.0)));
        const Prediction plain = predict_until(a, fa, b, fb, 4.0);
        for (const int power : {-100, -3, 5, 100}) {
            const double length = std::ldexp(1.0, power);
            const double time = std::ldexp(1.0, -power / 2);
            const auto scaled_polygon = [&](const Polygon& polygon) {
                std::vector<Vec2> ring;
                for (const Vec2& vertex : polygon.vertices()) ring.push_back(length * vertex);
                return Polygon({ring});
            };
            const auto scaled_flyer = [&](const Flyer& flyer) {
                Flyer scaled = flyer;
                scaled.state.position *= length;
                scaled.state.velocity *= length / time;
                scaled.state.spin /= time;
                scaled.state.time *= time;
                return scaled;
            };
            const Prediction scaled = predict_until(scaled_polygon(a), scaled_flyer(fa), scaled_polygon(b),
                                                    scaled_flyer(fb), 4.0 * time);
            CHECK(scaled.kind == plain.kind);
            CHECK(scaled.time == plain.time * time);
        }
    }
}

TEST_CASE("a corner that touches a wall a little deep, and hardly leaves it, is seen to leave it after a few steps")
{
    // Planks lie nearly flat, so that turning hardly lifts the corner on which they stand: steps as long as the rate
    // alone allows took for ever
    for (const double thin : {1e-3, 1e-6, 1e-9}) {
        for (const double deep : {0.6, 0.9, 0.999}) {
            const Polygon plank = box(1.0, thin);
            Flyer flyer;
            flyer.state.angle = -thin;
            flyer.state.spin = -1.0;
            const double c = std::cos(thin);
            const double d = std::sin(thin);
            const Vec2 corner(0.5 * c - 0.5 * thin * d, -0.5 * d - 0.5 * thin * c);
            const double touch = tolerance::k_touch * plank.radius();
            flyer.state.position = Vec2(0.0, -corner.y() - deep * touch);
            flyer.state.velocity = Vec2(0.0, -flyer.state.spin * corner.x() + 1e-17);
            CAPTURE(thin);
            CAPTURE(deep);
            Prediction answer{Prediction::Kind::not_before, 0.0, {}};
            int looks = 0;
            for (; looks < 100 && answer.kind == Prediction::Kind::not_before && answer.time < 0.1; ++looks)
                answer = predict(plank, flyer, HalfPlane{Vec2(0.0, 1.0), 0.0}, Flyer{}, answer.time);
            CHECK(looks < 100);
        }
    }
}
