#include <algorithm>
#include <doctest/doctest.h>
#include <numeric>
#include <set>

#include FLYING_ANSWER

#include "support/patience.hpp"
#include "support/say_lists.hpp"

namespace {

std::vector<int> up_to(int count)
{
    std::vector<int> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

} // namespace

TEST_CASE("what breaks by one body comes down to that body")
{
    Patience patience("breaks", 10'000);
    const auto has_five = [&](const std::vector<int>& chosen) {
        patience.count();
        return std::count(chosen.begin(), chosen.end(), 5) > 0;
    };
    CHECK_MESSAGE(fewest(up_to(17), has_five) == std::vector<int>{5},
                  "body 5 alone breaks it: leave out all the others");
}

TEST_CASE("two bodies far apart in the list are both kept, within sixty tries")
{
    Patience patience("breaks", 10'000);
    const auto has_both = [&](const std::vector<int>& chosen) {
        patience.count();
        const std::set<int> set(chosen.begin(), chosen.end());
        return set.contains(3) && set.contains(60);
    };
    CHECK(fewest(up_to(64), has_both) == std::vector<int>{3, 60});
    const int tries = patience.calls();
    CHECK_MESSAGE(tries <= 60, "leave out halves first, then quarters");
}

TEST_CASE("where any three will do, three are left")
{
    const auto has_three = [](const std::vector<int>& chosen) { return chosen.size() >= 3; };
    CHECK(fewest(up_to(20), has_three).size() == 3);
}

TEST_CASE("no single body can be left out of the answer")
{
    const auto breaks = [](const std::vector<int>& chosen) {
        const int sum = std::accumulate(chosen.begin(), chosen.end(), 0);
        return sum >= 40;
    };
    const std::vector<int> few = fewest(up_to(16), breaks);
    CHECK(breaks(few));
    for (std::size_t k = 0; k < few.size(); ++k) {
        std::vector<int> fewer = few;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
        CHECK_FALSE(breaks(fewer));
    }
}

TEST_CASE("what was needed only for a while is left out as well")
{
    // Body 2 can't go before body 5 has gone
    const auto breaks = [](const std::vector<int>& chosen) {
        const std::set<int> set(chosen.begin(), chosen.end());
        return set.contains(3) && set.contains(4) && set.contains(9) && (!set.contains(5) || set.contains(2));
    };
    CHECK(fewest(up_to(16), breaks) == std::vector<int>{3, 4, 9});
}
