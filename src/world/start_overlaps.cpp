#include "world/start_overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>

#include "broadphase/grid.hpp"
#include "math/tolerance.hpp"

namespace flying {

double start_overlap_allowed(double size, double reach)
{
    return tolerance::k_start_overlap * size + tolerance::coordinate_rounding(reach);
}

namespace {

/// Bodies whose boxes are about as long as the cells of one grid, in the order of a curve through its cells.
struct Level
{
    struct Entry
    {
        Aabb box;
        int body = 0;
        bool is_static = false;
    };
    std::vector<Entry> entries;
    std::optional<Grid> grid;
};

/// The exponent of the least power of two of which no box of this length fills more than eight ninths, so that boxes
/// that share a point lie in neighbouring cells, whatever their middles' rounding.
int exponent_for(const Aabb& box)
{
    int exponent = 0;
    (void)std::frexp(1.125 * (box.max - box.min).maxCoeff(), &exponent);
    return exponent;
}

Vec2 middle(const Aabb& box) { return 0.5 * box.min + 0.5 * box.max; }

/// Put a level's bodies into its cells.
void fill_cells(Level& level, double cell_size)
{
    // Cells for all bodies, and hardly more
    int columns = 4;
    while (static_cast<std::int64_t>(columns) * columns < static_cast<std::int64_t>(level.entries.size())) columns *= 2;
    const int count = static_cast<int>(level.entries.size());
    Grid grid(cell_size, columns, columns, count);

    // Neighbours in the plane become neighbours in memory
    std::vector<std::pair<std::uint64_t, int>> order;
    order.reserve(level.entries.size());
    for (int k = 0; k < count; ++k) {
        order.emplace_back(grid.along_curve(grid.cell_at(middle(level.entries[k].box))), k);
    }
    std::sort(order.begin(), order.end());
    std::vector<Level::Entry> entries;
    entries.reserve(level.entries.size());
    for (const auto& [key, k] : order) entries.push_back(level.entries[k]);
    level.entries.swap(entries);
    for (int k = 0; k < count; ++k) grid.insert(k, grid.cell_at(middle(level.entries[k].box)));
    level.grid = std::move(grid);
}

/// Call visit(a, b) for every two bodies, not both static, whose boxes share a point. It returns true to go on, false to
/// end the search.
///
/// Boxes of all lengths may come together: each is put into a grid of cells of its own length, and looks about in that
/// and in all that are coarser. A thousand lengths from the shortest to the longest are ten grids.
template <typename Visit>
void for_each_near_pair(const std::vector<PlacedBody>& bodies, Visit&& visit)
{
    std::map<int, Level> levels;
    for (int k = 0; k < static_cast<int>(bodies.size()); ++k) {
        levels[exponent_for(bodies[k].box)].entries.push_back({bodies[k].box, k, bodies[k].is_static});
    }
    for (auto& [exponent, level] : levels) fill_cells(level, std::ldexp(1.0, exponent));
    for (auto fine = levels.begin(); fine != levels.end(); ++fine) {
        for (auto coarse = fine; coarse != levels.end(); ++coarse) {
            const std::vector<Level::Entry>& others = coarse->second.entries;
            const Grid& grid = *coarse->second.grid;
            for (int k = 0; k < static_cast<int>(fine->second.entries.size()); ++k) {
                const Level::Entry& one = fine->second.entries[k];
                bool goes_on = true;
                grid.for_each_near(grid.cell_at(middle(one.box)), [&](int other) {
                    if (!goes_on || (fine == coarse && other <= k)) return;
                    const Level::Entry& two = others[other];
                    if ((one.is_static && two.is_static) || !overlap(one.box, two.box)) return;
                    goes_on = visit(std::min(one.body, two.body), std::max(one.body, two.body));
                });
                if (!goes_on) return;
            }
        }
    }
}

} // namespace

std::vector<StartOverlap> find_start_overlaps(const std::vector<PlacedBody>& bodies, std::size_t most)
{
    // Look at each pair of boxes that overlap, until there are too many to name
    std::vector<StartOverlap> overlaps;
    for_each_near_pair(bodies, [&](int j, int k) {
        const PlacedBody& a = bodies[j];
        const PlacedBody& b = bodies[k];
        const double depth = -separation(a.shape, a.pose, b.shape, b.pose);
        const double reach = a.pose.position.norm() + b.pose.position.norm() + a.size + b.size;
        if (depth > start_overlap_allowed(std::min(a.size, b.size), reach)) {
            overlaps.push_back({std::min(a.index, b.index), std::max(a.index, b.index), depth});
        }
        return overlaps.size() <= most;
    });

    std::sort(overlaps.begin(), overlaps.end(), [](const StartOverlap& a, const StartOverlap& b) {
        return std::tuple(a.second, a.first) < std::tuple(b.second, b.first);
    });
    if (overlaps.size() > most) overlaps.resize(most);
    return overlaps;
}

} // namespace flying
