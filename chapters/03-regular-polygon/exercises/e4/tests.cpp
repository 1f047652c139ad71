#include <cmath>
#include <initializer_list>
#include <numbers>

#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "support/patience.hpp"

namespace {

/// By how much a regular polygon of n sides falls short of the disc through its corners.
double gap_by_radius(long n)
{
    const double x = std::numbers::pi / static_cast<double>(n);
    const double s = std::sin(x);
    return 1.0 - std::sin(2 * x) / (2 * x) * (1.0 - 2.0 / 3.0 * s * s);
}

} // namespace

TEST_CASE("few sides, as counting finds them")
{
    for (const double share : {0.9, 0.5, 0.1, 0.01, 1e-4, 1e-6}) {
        CAPTURE(share);
        long n = 3;
        while (gap_by_radius(n) > share) ++n;
        CHECK(first_within(gap_by_radius, share) == n);
    }
}

TEST_CASE("many sides, in few calls")
{
    Patience patience("gap", 1000);
    const auto gap = [&](long n) {
        patience.count();
        return 1.0 / (static_cast<double>(n) * static_cast<double>(n));
    };
    CHECK(first_within(gap, 1.0 / (1e9 * 1e9)) == 1000000000);
    const int calls = patience.calls();
    CHECK(calls <= 100);
}
