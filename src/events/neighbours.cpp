#include "events/neighbours.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace flying {
namespace {

/// cell_of(row)  where a mover lies
template <typename CellOf>
[[nodiscard]] std::vector<int> order_of(const BodyRows& bodies, const Grid& grid, const CellOf& cell_of)
{
    constexpr std::uint64_t k_last = ~std::uint64_t{0};
    std::vector<std::pair<std::uint64_t, int>> keys;
    for (int row = 0; row < bodies.count(); ++row) {
        keys.emplace_back(bodies.never_moves(row) ? k_last : grid.along_curve(cell_of(row)), row);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<int> order;
    for (const auto& [key, row] : keys) order.push_back(row);
    return order;
}

} // namespace

Neighbours::Neighbours(const BodyRows& bodies, double time)
{
    // Cells are no smaller than the largest mover
    int movers = 0;
    Aabb extent{Vec2::Constant(k_never), Vec2::Constant(-k_never)};
    for (int row = 0; row < bodies.count(); ++row) {
        if (bodies.never_moves(row)) continue;
        const Vec2 here = bodies.position_at(row, time);
        largest_ = std::max(largest_, bodies[row].radius);
        extent.min = extent.min.cwiseMin(here);
        extent.max = extent.max.cwiseMax(here);
        ++movers;
    }
    if (movers > 0) grid_ = make_grid(extent, largest_, bodies.count(), movers);
}

std::vector<int> Neighbours::order_along_curve(const BodyRows& bodies, double time) const
{
    return order_of(bodies, *grid_, [&](int row) { return grid_->cell_at(bodies.position_at(row, time)); });
}

std::vector<int> Neighbours::order_along_curve(const BodyRows& bodies) const
{
    return order_of(bodies, *grid_, [&](int row) { return grid_->cell_of(row); });
}

void Neighbours::line_up(const BodyRows& bodies, std::span<const int> old_rows)
{
    std::size_t movers = 0;
    while (movers < old_rows.size() && !bodies.never_moves(static_cast<int>(movers))) ++movers;
    grid_->renumber(old_rows.first(movers));
}

void Neighbours::enter(const BodyRows& bodies, double time)
{
    for (int row = 0; row < bodies.count(); ++row) {
        if (bodies.never_moves(row)) enter_static(bodies, row);
        else grid_->insert(row, grid_->cell_at(bodies.position_at(row, time)));
    }
}

void Neighbours::enter_static(const BodyRows& bodies, int row)
{
    const Shape& shape = bodies.shape_of(row);
    const auto* wall = std::get_if<HalfPlane>(&shape);
    if (!wall) {
        grid_->insert_static(row, bounding_box(shape, bodies.pose(row)), largest_);
        return;
    }

    // A wall along an axis is met only near its surface: no body is ever behind it
    const bool level = wall->normal.x() == 0.0;
    if (!level && wall->normal.y() != 0.0) {
        everywhere_.push_back(row);
        return;
    }
    const double surface = wall->offset * (level ? wall->normal.y() : wall->normal.x());
    const Vec2 low = level ? Vec2(-k_never, surface) : Vec2(surface, -k_never);
    const Vec2 high = level ? Vec2(k_never, surface) : Vec2(surface, k_never);
    grid_->insert_static(row, {low, high}, largest_);
}

} // namespace flying
