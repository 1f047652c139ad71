#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "rest/sleepers.hpp"

using namespace flying;

TEST_CASE("an island sleeps and wakes as a whole")
{
    Sleepers sleepers(6);
    CHECK(sleepers.count() == 0);
    for (const int body : {1, 3, 4}) sleepers.put_to_sleep(body, 1);
    sleepers.put_to_sleep(2, 2);
    CHECK(sleepers.count() == 4);
    CHECK(sleepers.island_of(4) == 1);
    CHECK_FALSE(sleepers.is_asleep(5));
    CHECK(sleepers.fetch_changed() == std::vector<int>{1, 3, 4, 2});

    CHECK_FALSE(sleepers.wake(-1));
    CHECK_FALSE(sleepers.wake(5));
    CHECK(sleepers.fetch_changed().empty());
    CHECK(sleepers.wake(1));
    CHECK_FALSE(sleepers.wake(1));
    CHECK(sleepers.count() == 1);
    CHECK_FALSE(sleepers.is_asleep(3));
    CHECK(sleepers.is_asleep(2));
    std::vector<int> woken = sleepers.fetch_changed();
    std::sort(woken.begin(), woken.end());
    CHECK(woken == std::vector<int>{1, 3, 4});
}
