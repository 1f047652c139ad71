#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "math/random.hpp"
#include "support/patience.hpp"

TEST_CASE("the first zero of a wave is found")
{
    flying::Random random(851);
    for (int k = 0; k < 1000; ++k) {
        const double w = random.uniform(0.5, 5.0);
        const double phase = random.uniform(-1.0, 1.0);
        const double height = random.uniform(-0.4, 0.9); // less than cos(1), so that it starts above zero
        Patience patience("f", 1'000'000);
        const auto f = [&](double t) {
            patience.count();
            return Reading{std::cos(w * t + phase) + height, -w * std::sin(w * t + phase)};
        };
        const double root = (std::acos(-height) - phase) / w;
        CAPTURE(w);
        CAPTURE(phase);
        CAPTURE(height);
        CHECK(std::abs(first_zero(f, w * w, 100.0, 1e-14) - root) <= 1e-12);
    }
}

TEST_CASE("a dip too narrow for any camera is found, and a wave that stays above it is left alone")
{
    for (const double depth : {1e-8, -1e-8}) {
        Patience patience("f", 1'000'000);
        const auto f = [&](double t) {
            patience.count();
            return Reading{1.0 - depth + std::cos(t), -std::sin(t)};
        };
        const double found = first_zero(f, 1.0, 6.0, 1e-15);
        if (depth > 0.0) CHECK(std::abs(found - std::acos(depth - 1.0)) < 1e-9);
        else CHECK(std::isinf(found));
        const int calls = patience.calls();
        CHECK(calls < 200);
    }
}

TEST_CASE("a straight fall takes one step, also where nothing bends")
{
    Patience patience("f", 1'000'000);
    const auto f = [&](double t) {
        patience.count();
        return Reading{3.0 - 2.0 * t, -2.0};
    };
    CHECK(std::abs(first_zero(f, 0.0, 100.0, 1e-14) - 1.5) < 1e-14);
    const int calls = patience.calls();
    CHECK(calls == 2);
}
