#include <doctest/doctest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "broadphase/box_cells.hpp"
#include "math/random.hpp"

using namespace flying;

namespace {

/// One in twenty is large; all lie in a row, or wherever in the plane.
Aabb random_box(Random& random, bool in_a_row)
{
    const double x = random.uniform(-10.0, 10.0);
    const double y = in_a_row ? 0.0 : random.uniform(-1.0, 30.0);
    const double least = random.below(20) == 0 ? 15.0 : 0.1;
    const double width = 0.25 * random.below(5) + least;
    const double height = 0.25 * random.below(5);
    return Aabb{Vec2(x, y), Vec2(x + width, y + height)};
}

std::vector<BoxCells::Entry> random_boxes(Random& random, bool in_a_row)
{
    std::vector<BoxCells::Entry> entries;
    const int count = random.below(60);
    for (int k = 0; k < count; ++k) entries.push_back({random_box(random, in_a_row), k});
    return entries;
}

} // namespace

TEST_CASE("boxes in cells are found by all that share a point with them, whatever their sizes")
{
    Random random(801);
    for (int round = 0; round < 200; ++round) {
        const bool in_a_row = round % 3 == 0;
        const std::vector<BoxCells::Entry> entries = random_boxes(random, in_a_row);
        BoxCells cells;
        cells.sort(entries);
        for (int k = 0; k < 50; ++k) {
            const Aabb asked = random_box(random, in_a_row);
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

TEST_CASE("boxes in cells: all pairs that share a point are found, each once")
{
    Random random(802);
    for (int round = 0; round < 200; ++round) {
        const std::vector<BoxCells::Entry> entries = random_boxes(random, round % 3 == 0);
        BoxCells cells;
        cells.sort(entries);
        std::vector<std::pair<int, int>> found;
        cells.for_each_pair([&](const BoxCells::Entry& one, const BoxCells::Entry& two) {
            found.emplace_back(std::min(one.body, two.body), std::max(one.body, two.body));
        });
        std::sort(found.begin(), found.end());
        std::vector<std::pair<int, int>> expected;
        for (const BoxCells::Entry& one : entries) {
            for (int k = one.body + 1; k < static_cast<int>(entries.size()); ++k) {
                if (overlap(one.box, entries[static_cast<std::size_t>(k)].box)) expected.emplace_back(one.body, k);
            }
        }
        CHECK(found == expected);
    }
}

TEST_CASE("boxes in cells: those that are all one point, so far out that a body is less than a rounding")
{
    for (const double x : {0.0, 7.7e26}) {
        const Aabb point{Vec2(x, -x), Vec2(x, -x)};
        BoxCells cells;
        cells.sort({{point, 0}, {point, 1}, {point, 2}});
        int pairs = 0;
        cells.for_each_pair([&](const BoxCells::Entry&, const BoxCells::Entry&) { ++pairs; });
        CHECK(pairs == 3);
    }
}
