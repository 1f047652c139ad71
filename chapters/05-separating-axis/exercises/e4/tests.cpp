#include <algorithm>
#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "collide/separation.hpp"

namespace {

std::vector<Vec2> regular(int n, double radius, const Vec2& middle, double turn)
{
    std::vector<Vec2> ring;
    for (int k = 0; k < n; ++k) {
        const double angle = turn + 2.0 * 3.14159265358979 * k / n;
        ring.push_back(middle + radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return ring;
}

} // namespace

TEST_CASE("corner looks at corner")
{
    const std::vector<Vec2> a = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    const std::vector<Vec2> b = {Vec2(4, 5), Vec2(5, 5), Vec2(5, 6), Vec2(4, 6)};
    CHECK(distance(a, b) == doctest::Approx(5.0));
}

TEST_CASE("the engine's separation is the same, apart and overlapping")
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int k = 0; k < 500; ++k) {
        const auto a = regular(3 + k % 5, 1.0, Vec2(0, 0), any(random));
        const auto b = regular(3 + k % 4, 0.7, Vec2(2.5 * any(random), 2.5 * any(random)), any(random));
        const double found = flying::separation(flying::Polygon({a}), {}, flying::Polygon({b}), {});
        CHECK(distance(a, b) == doctest::Approx(std::max(0.0, found)).epsilon(1e-9));
    }
}
