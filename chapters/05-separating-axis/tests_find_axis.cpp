#include <cmath>

#include <doctest/doctest.h>

#include "find_axis.hpp"
#include "math/tolerance.hpp"
#include "support/random_polygons.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

/// Roundings of a separation of bodies a few metres in size and apart: some twenty operations on numbers below 8.
constexpr double k_roundings = 20.0 * 8.0 * tolerance::k_epsilon;

} // namespace

TEST_CASE("a separating axis is found exactly where the greatest separation is positive, with a guess or without")
{
    Random random(504);
    for (int k = 0; k < 5000; ++k) {
        const Polygon a = random_convex(random);
        const Polygon b = random_convex(random);
        const Pose a_from_b = random_pose(random, 2.0);
        const Axis greatest = greatest_separation(a, b, a_from_b);
        if (std::abs(greatest.separation) < k_roundings) continue;
        const std::optional<Axis> found = find_separating_axis(a, b, a_from_b);
        REQUIRE(found.has_value() == (greatest.separation > 0.0));
        if (!found) continue;
        CHECK(found->separation > 0.0);
        CHECK(found->separation <= greatest.separation + k_roundings);

        // The cached axis parts the two again at once
        const std::optional<Axis> again = find_separating_axis(a, b, a_from_b, greatest);
        REQUIRE(again);
        CHECK(again->owner == greatest.owner);
        CHECK(again->edge == greatest.edge);
    }
}
