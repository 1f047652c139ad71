#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "support/say_lists.hpp"

TEST_CASE("two stacks on one floor")
{
    // 0 is the floor; 1 and 3 are one stack, 2 and 4 the other, 5 flies
    const std::vector<bool> is_static = {true, false, false, false, false, false};
    const std::vector<int> expected = {0, 1, 2, 1, 2, 5};
    CHECK(islands(is_static, {{0, 1}, {3, 1}, {0, 2}, {2, 4}}) == expected);
    CHECK(islands(is_static, {}) == std::vector<int>{0, 1, 2, 3, 4, 5});
}

TEST_CASE("joined late, and in any order")
{
    const std::vector<bool> none(6, false);
    CHECK(islands(none, {{4, 5}, {2, 3}, {0, 1}, {3, 4}, {5, 0}}) == std::vector<int>(6, 0));
}

constexpr int k_many = 1000000;

TEST_CASE("a chain of a million bodies")
{
    std::vector<std::pair<int, int>> contacts;
    for (int k = k_many - 1; k > 0; --k) contacts.emplace_back(k, k - 1);
    const std::vector<int> found = islands(std::vector<bool>(k_many, false), contacts);
    REQUIRE(found.size() == k_many);
    CHECK(found.front() == 0);
    CHECK(found.back() == 0);
}

TEST_CASE("a million bodies that all touch the last")
{
    std::vector<std::pair<int, int>> contacts;
    for (int k = k_many - 1; k > 0; --k) contacts.emplace_back(k_many - 1, k - 1);
    const std::vector<int> found = islands(std::vector<bool>(k_many, false), contacts);
    REQUIRE(found.size() == k_many);
    CHECK(found.front() == 0);
    CHECK(found.back() == 0);
}
