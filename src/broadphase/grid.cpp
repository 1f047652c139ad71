#include "broadphase/grid.hpp"

#include <algorithm>
#include <bit>

namespace flying {

Grid::Grid(double cell_size, int columns, int rows, int bodies)
    : cell_size_(cell_size), column_mask_(static_cast<std::uint64_t>(columns) - 1),
      row_mask_(static_cast<std::uint64_t>(rows) - 1), row_shift_(std::countr_zero(static_cast<unsigned>(columns))),
      heads_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)), next_(bodies, -1), cell_of_(bodies),
      statics_(1)
{
}

Cell Grid::cell_at(const Vec2& point) const
{
    constexpr double k_farthest = 0x1p50;
    const auto number = [&](double x) {
        return static_cast<std::int64_t>(
            std::clamp(std::floor(x / cell_size_), -k_farthest, k_farthest));
    };
    return {number(point.x()), number(point.y())};
}

void Grid::insert(int body, const Cell& cell)
{
    Head& head = heads_[index(cell)];
    cell_of_[body] = cell;
    for (int& place : head.bodies) {
        if (place >= 0) continue;
        place = body;
        return;
    }
    next_[body] = head.chain;
    head.chain = body;
}

void Grid::move(int body, const Cell& to)
{
    // Find what names the body: its cell, or another in the chain
    Head& head = heads_[index(cell_of_[body])];
    int* place = &head.bodies[0];
    if (*place != body) place = &head.bodies[1];
    if (*place != body) {
        place = &head.chain;
        while (*place != body) place = &next_[*place];
        *place = next_[body];
    } else {
        // Leave no place empty before one that is taken
        int& last = head.chain >= 0       ? head.chain
                    : head.bodies[1] >= 0 ? head.bodies[1]
                                          : head.bodies[0];
        *place = last;
        last = &last == &head.chain ? next_[last] : -1;
    }
    insert(body, to);
}

void Grid::renumber(std::span<const int> old_ids)
{
    const std::vector<Cell> old_cells = cell_of_;
    for (Head& head : heads_) head = {{-1, -1}, -1, head.statics};
    for (std::size_t k = old_ids.size(); k-- > 0;) insert(static_cast<int>(k), old_cells[old_ids[k]]);
}

std::uint64_t Grid::along_curve(const Cell& cell) const
{
    // Put a zero between each bit and the next
    const auto spread = [](std::uint64_t x) {
        x = (x | x << 16) & 0x0000ffff0000ffffull;
        x = (x | x << 8) & 0x00ff00ff00ff00ffull;
        x = (x | x << 4) & 0x0f0f0f0f0f0f0f0full;
        x = (x | x << 2) & 0x3333333333333333ull;
        return (x | x << 1) & 0x5555555555555555ull;
    };
    const auto column = static_cast<std::uint64_t>(cell.column) & column_mask_;
    const auto row = static_cast<std::uint64_t>(cell.row) & row_mask_;
    return spread(column) | spread(row) << 1;
}

void Grid::insert_static(int body, const Aabb& box, double margin)
{
    // A cell's width more on each side, for bodies that stand on a border by rounding
    const Vec2 reach = Vec2::Constant(margin + cell_size_);
    const Cell low = cell_at(box.min - reach);
    const Cell high = cell_at(box.max + reach);

    // A box wider than the torus reaches every column once
    const std::int64_t last_column =
        std::min(high.column, low.column + static_cast<std::int64_t>(column_mask_));
    const std::int64_t last_row =
        std::min(high.row, low.row + static_cast<std::int64_t>(row_mask_));
    for (std::int64_t row = low.row; row <= last_row; ++row) {
        for (std::int64_t column = low.column; column <= last_column; ++column) {
            // [grid.statics.name]
            int& statics = heads_[index({column, row})].statics;
            if (statics == 0) {
                statics = static_cast<int>(statics_.size());
                statics_.emplace_back();
            }
            statics_[statics].push_back(body);
            // [grid.statics.name]
        }
    }
}

Grid make_grid(const Aabb& extent, double largest_radius, int bodies, int movers)
{
    // A diameter, and room for the rounding of borders, in radii
    constexpr double k_clear = 2.125;
    constexpr double k_bodies_a_cell = 0.5;
    const Vec2 size = extent.max - extent.min;
    const double share =
        std::sqrt(k_bodies_a_cell * (size.x() * size.y()) / std::max(movers, 1));
    const double cell_size = std::max(k_clear * largest_radius, share);

    // [grid.make.count]
    // Powers of two wrap without a division
    const double most = std::sqrt(4.0 * bodies + 16.0);
    const auto count = [&](double length) {
        const double wanted = std::clamp(std::ceil(length / cell_size) + 1.0, 4.0, std::max(4.0, most));
        return static_cast<int>(std::bit_ceil(static_cast<unsigned>(wanted)));
    };
    // [grid.make.count]
    return Grid(cell_size, count(size.x()), count(size.y()), bodies);
}

} // namespace flying
