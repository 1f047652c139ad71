#pragma once

#include <optional>
#include <span>
#include <vector>

#include "broadphase/grid.hpp"
#include "events/body_rows.hpp"

namespace flying {

/// Which bodies a body may meet before either changes its cell; without cells, all of them. Bodies are named by their
/// rows.
class Neighbours
{
public:
    /// No cells: every two bodies are neighbours.
    Neighbours() = default;
    /// Cells fit for where the bodies are at a moment; they are empty yet.  [s]
    Neighbours(const BodyRows& bodies, double time);

    /// The order in which rows follow a curve through the cells; static bodies come last.
    [[nodiscard]] std::vector<int> order_along_curve(const BodyRows& bodies, double time) const;
    /// The same of bodies that are in their cells.
    [[nodiscard]] std::vector<int> order_along_curve(const BodyRows& bodies) const;
    /// Put all into the cells where they are at a moment.  [s]
    void enter(const BodyRows& bodies, double time);
    /// As BodyRows::line_up, after it, in an order along the curve.
    void line_up(const BodyRows& bodies, std::span<const int> old_rows);

    [[nodiscard]] bool has_cells() const { return grid_.has_value(); }
    /// The cells, where there are any.
    [[nodiscard]] const Grid& cells() const { return *grid_; }
    /// Move a body to the cell of a point, or to the one beside its own, where there are cells.
    void move(int row, const Cell& to) { grid_->move(row, to); }

    /// Write down the bodies that can move and may meet this one, itself among them, where there are cells.
    /// near  room for one more than all bodies. Returns the end of the list.
    [[nodiscard]] int* gather_movers(int row, int* near) const { return grid_->gather_near(grid_->cell_of(row), near); }
    /// Call visit(other) for every static body that may meet this one, where there are cells.
    template <typename Visit>
    void for_each_static(int row, Visit&& visit) const
    {
        for (const int other : grid_->statics_near(grid_->cell_of(row))) visit(other);
        for (const int other : everywhere_) visit(other);
    }

private:
    void enter_static(const BodyRows& bodies, int row);

    std::optional<Grid> grid_;
    std::vector<int> everywhere_; // static bodies that no cell can hold
    double largest_ = 0.0;        // bounding radius of those that move [m]
};

} // namespace flying
