#include <algorithm>
#include <cstdint>
#include <doctest/doctest.h>

#include FLYING_ANSWER

TEST_CASE("every drift of a degree below k comes to the same for both engines, in whole numbers")
{
    for (int k = 1; k <= 7; ++k) {
        const std::vector<int> order = fair_order(k);
        REQUIRE(order.size() == std::size_t{1} << k);
        for (int degree = 0; degree < k; ++degree) {
            std::int64_t difference = 0;
            for (std::size_t turn = 0; turn < order.size(); ++turn) {
                REQUIRE((order[turn] == 0 || order[turn] == 1));
                std::int64_t drift = 1;
                for (int power = 0; power < degree; ++power) drift *= static_cast<std::int64_t>(turn);
                difference += order[turn] == 0 ? drift : -drift;
            }
            CAPTURE(k);
            CAPTURE(degree);
            CHECK(difference == 0);
        }
    }
}

TEST_CASE("both have as many turns")
{
    const std::vector<int> order = fair_order(6);
    CHECK(std::count(order.begin(), order.end(), 0) == 32);
}
