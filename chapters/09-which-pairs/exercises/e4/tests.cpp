#include <random>

#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "support/say_lists.hpp"

namespace {

std::vector<Vec2> crowd(int count, double width)
{
    std::mt19937_64 random(23);
    std::uniform_real_distribution<double> any(-width, width);
    std::vector<Vec2> points;
    for (int k = 0; k < count; ++k) points.push_back(Vec2(any(random), any(random)));
    return points;
}

} // namespace

TEST_CASE("a few points, by hand")
{
    const std::vector<Vec2> points = {Vec2(0, 0), Vec2(1, 0), Vec2(0.5, 0.5), Vec2(-3, 0), Vec2(-3, -1)};
    const std::vector<std::pair<int, int>> expected = {{0, 1}, {0, 2}, {1, 2}, {3, 4}};
    CHECK(near_pairs(points, 1.0) == expected);
}

TEST_CASE("as all pairs find them")
{
    const std::vector<Vec2> points = crowd(400, 5.0);
    std::vector<std::pair<int, int>> expected;
    for (int i = 0; i < 400; ++i)
        for (int k = i + 1; k < 400; ++k)
            if ((points[i] - points[k]).squaredNorm() <= 0.25) expected.emplace_back(i, k);
    const std::vector<std::pair<int, int>> found = near_pairs(points, 0.5);
    CHECK(found.size() == expected.size());
    CHECK(found == expected);
}

TEST_CASE("two hundred thousand points")
{
    const auto pairs = near_pairs(crowd(200000, 1600.0), 1.0);
    CHECK(pairs.size() > 5700); // a chance of pi / 3200^2 for each of 2e10 pairs: 6136, give or take 80
    CHECK(pairs.size() < 6600);
}
