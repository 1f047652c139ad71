#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>

#include FLYING_ANSWER

TEST_CASE("a fall by few steps becomes exact")
{
    for (const int n : {1, 3, 10, 1000}) {
        CAPTURE(n);
        int steps = 0;
        const auto fall = [&](int count) {
            steps += count;
            return 0.5 * 9.81 * 4.0 * (1.0 - 1.0 / count);
        };
        CHECK(std::abs(extrapolated(fall, n) - 0.5 * 9.81 * 4.0) < 1e-13);
        CHECK(steps <= 3 * n);
    }
}

TEST_CASE("a growth by steps gains an order")
{
    const auto growth = [](int count) { return std::pow(1.0 + 1.0 / count, count); };
    const auto miss = [&](int n) { return std::abs(extrapolated(growth, n) - std::exp(1.0)); };
    CHECK(miss(100) < 0.01 * std::abs(growth(100) - std::exp(1.0)));
    CHECK(std::abs(std::log2(miss(400) / miss(800)) - 2.0) < 0.05);
}
