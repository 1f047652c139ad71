#include <doctest/doctest.h>

#include "rest/sleepers.hpp"

using namespace flying;

TEST_CASE("an island sleeps and wakes as a whole")
{
    Sleepers sleepers(6);
    CHECK(sleepers.count() == 0);
    for (const int body : {1, 3, 4}) sleepers.set(body, 1);
    sleepers.set(2, 2);
    CHECK(sleepers.count() == 4);
    CHECK(sleepers.island_of(4) == 1);
    CHECK_FALSE(sleepers.is_asleep(5));

    CHECK_FALSE(sleepers.wake(-1));
    CHECK_FALSE(sleepers.wake(5));
    CHECK(sleepers.wake(1));
    CHECK(sleepers.count() == 1);
    CHECK_FALSE(sleepers.is_asleep(3));
    CHECK(sleepers.is_asleep(2));
    sleepers.set(2, -1);
    CHECK(sleepers.count() == 0);
}
