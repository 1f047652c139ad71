#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "math/random.hpp"

TEST_CASE("the count is that of looking at every pair")
{
    flying::Random random(951);
    for (int run = 0; run < 300; ++run) {
        std::vector<Interval> spans;
        const int n = random.below(40);
        for (int k = 0; k < n; ++k) {
            // Every second time on whole numbers, so that ends meet starts
            const double low = run % 2 == 0 ? random.below(20) : random.uniform(0.0, 20.0);
            const double length = run % 2 == 0 ? random.below(4) : random.uniform(0.0, 4.0);
            spans.push_back({low, low + length});
        }
        long expected = 0;
        for (int a = 0; a < n; ++a) {
            for (int b = a + 1; b < n; ++b) {
                expected += spans[a].low <= spans[b].high && spans[b].low <= spans[a].high ? 1 : 0;
            }
        }
        CAPTURE(n);
        CHECK(count_side_by_side(spans) == expected);
    }
}

TEST_CASE("a million intervals that all share a place are half a trillion pairs")
{
    std::vector<Interval> spans;
    for (int k = 0; k < 1'000'000; ++k) spans.push_back({-1.0 - k, 1.0 + k});
    CHECK(count_side_by_side(spans) == 499'999'500'000);
}
