#include <doctest/doctest.h>

#include "stages.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("islands are chains of bodies that move: what is static joins none")
{
    // Two stacks and a lone box on one floor, and a box in the air
    RestData data = data_of({ground(), box_at({0.0, 0.5}), box_at({5.0, 0.5}), box_at({0.0, 1.5}), box_at({5.0, 1.5}),
                             box_at({9.0, 0.5}), box_at({14.0, 8.0})});
    std::vector<ContactPoint> found = contacts_of(data);
    const std::size_t count = found.size();
    CHECK(count == 10); // two points under each of five boxes

    Islands islands;
    islands.split(data, moved_in(data), found);
    const std::vector<std::vector<int>> expected = {{1, 3}, {2, 4}, {5}, {6}};
    const std::vector<std::size_t> points = {4, 4, 2, 0};
    REQUIRE(islands.all().size() == expected.size());
    CHECK(islands.point_count() == count);
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const Island& island = islands.all()[k];
        CHECK(std::vector<int>(island.members.begin(), island.members.end()) == expected[k]);
        CHECK(island.points.size() == points[k]);
        for (const ContactPoint& c : island.points) {
            const bool is_own = std::find(expected[k].begin(), expected[k].end(), c.b) != expected[k].end();
            CHECK(is_own);
        }
    }
}

TEST_CASE("one island keeps the order of its pairs")
{
    RestData data = data_of({ground(), box_at({0.0, 0.5}), box_at({0.0, 1.5}), box_at({0.0, 2.5})});
    std::vector<ContactPoint> found = contacts_of(data);
    const std::vector<ContactPoint> before = found;
    Islands islands;
    islands.split(data, moved_in(data), found);
    REQUIRE(islands.all().size() == 1);
    const Island& island = islands.all()[0];
    REQUIRE(island.points.size() == before.size());
    for (std::size_t k = 0; k < before.size(); ++k) {
        CHECK(island.points[k].pair == before[k].pair);
        CHECK(island.points[k].own == before[k].own);
    }
}
