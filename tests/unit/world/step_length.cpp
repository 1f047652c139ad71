#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "math/random.hpp"
#include "world/step_length.hpp"

using namespace flying;

TEST_CASE("steps end at whole multiples of their length, the next or the one after, halved or not")
{
    Random random(2711);
    for (int k = 0; k < 10'000; ++k) {
        const double step = random.uniform(0.001, 0.1);
        const double time = random.uniform(0.0, 1000.0);
        const int halvings = k % 11;
        const double h = std::ldexp(step, -halvings);
        const double end = next_end(step, time, halvings);
        CHECK(end == std::round(end / h) * h);
        CHECK(end > time);
        CHECK(end - time <= h * (1.0 + 0x1p-20) + 1e-12); // rounding of times below 1000
        // Halves of halves lead to the ends of whole steps
        CHECK(next_end(step, time, halvings) <= next_end(step, time, 0) + 1e-12);
    }
}

TEST_CASE("of the parts into which a step is halved, the last one ends it as a whole one would")
{
    Random random(2713);
    for (int k = 0; k < 1000; ++k) {
        const double step = random.uniform(0.001, 0.1);
        const int halvings = k % 11;
        double time = random.below(100'000) * step;
        CHECK(ends_whole_step(step, time));
        for (int part = (1 << halvings) - 1; part >= 0; --part) {
            time = next_end(step, time, halvings);
            CHECK(ends_whole_step(step, time) == (part == 0));
        }
    }
}

TEST_CASE("a whole step, and one that was halved, has its length to the bit wherever it lies")
{
    constexpr double k_step = 1.0 / 60.0;
    for (int k = 0; k < 100'000; ++k) {
        const double from = k * k_step;
        CHECK(length_of_step(k_step, from, (k + 1.0) * k_step) == k_step);
        const double h = std::ldexp(k_step, -(k % 11));
        CHECK(length_of_step(k_step, k * h, (k + 1.0) * h) == h);
        CHECK(length_of_step(k_step, from, from + 0.005) == from + 0.005 - from);
    }
}

TEST_CASE("a step is halved as often as the formula says, and no more than ten times")
{
    Random random(2712);
    for (int k = 0; k < 10'000; ++k) {
        const double step = random.uniform(0.001, 0.1);
        const double pace = std::exp(random.uniform(0.0, 12.0));
        const double needed = std::ceil(std::log2(2.0 * pace * step));
        CHECK(halvings_for(step, pace) == static_cast<int>(std::min(10.0, std::max(0.0, needed))));
    }
}

TEST_CASE("a body at rest is as fast, by its size, as it would be after a fall of four sizes")
{
    const Field gravity = UniformField{{0.0, -9.81}};
    for (const double radius : {1e-3, 0.02, 1.0, 300.0}) {
        const Shape disc = Disc{radius};
        const Shape square = Polygon({{{-radius, 0.0}, {0.0, -radius}, {radius, 0.0}, {0.0, radius}}});
        BodyState state;
        const double fallen = std::sqrt(8.0 * 9.81 / radius);
        CHECK(pace_of(state, square, radius, gravity) == doctest::Approx(fallen).epsilon(1e-14));
        CHECK(pace_of(state, square, radius, {}) == 0.0);
        state.spin = -3.0;
        state.velocity = Vec2(0.0, 2.0 * fallen * radius);
        CHECK(pace_of(state, square, radius, gravity) == doctest::Approx(2.0 * fallen + 3.0).epsilon(1e-14));
        CHECK(pace_of(state, disc, radius, gravity) ==
              doctest::Approx(2.0 * fallen + std::min(3.0, 2.0 * fallen)).epsilon(1e-14));
    }
}
