#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "broadphase/box_cells.hpp"
#include "math/random.hpp"

using namespace flying;

TEST_CASE("boxes in cells are found by all that share a point with them, whatever their sizes")
{
    Random random(801);
    for (int round = 0; round < 200; ++round) {
        std::vector<BoxCells::Entry> entries;
        const int count = random.below(60);
        const auto any_box = [&] {
            const double x = random.uniform(-10.0, 10.0);
            const double y = round % 3 == 0 ? 0.0 : random.uniform(-1.0, 30.0);
            const double least = random.below(20) == 0 ? 15.0 : 0.1;
            const double width = 0.25 * random.below(5) + least;
            const double height = 0.25 * random.below(5);
            return Aabb{Vec2(x, y), Vec2(x + width, y + height)};
        };
        for (int k = 0; k < count; ++k) entries.push_back({any_box(), k});
        BoxCells cells;
        cells.sort(entries);
        for (int k = 0; k < 50; ++k) {
            const Aabb asked = any_box();
            std::vector<char> found(entries.size(), 0);
            CHECK(cells.visit_all_at(asked, [&](const BoxCells::Entry& entry) {
                found[static_cast<std::size_t>(entry.body)] = 1;
                return true;
            }));
            for (const BoxCells::Entry& entry : entries) {
                CHECK((found[static_cast<std::size_t>(entry.body)] != 0) == overlap(entry.box, asked));
            }
            const bool any = std::count(found.begin(), found.end(), 1) > 0;
            CHECK(cells.visit_all_at(asked, [](const BoxCells::Entry&) { return false; }) == !any);
        }
    }
}
