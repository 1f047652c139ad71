#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/aabb.hpp"
#include "math/fetch.hpp"

namespace flying {

/// A square cell of the plane, by column and row; cell (0, 0) has its lower left corner at the origin.
struct Cell
{
    std::int64_t column = 0;
    std::int64_t row = 0;

    friend bool operator==(const Cell&, const Cell&) = default;
};

/// Which body lies in which square cell. The plane is wrapped round a torus of cells, so that it has no border: bodies a
/// whole turn apart share a cell, which costs a needless look and never an overlooked pair.
///
/// Two bodies whose centres lie in cells that don't touch are at least one cell size apart; with cells no smaller than the
/// largest moving body, they can't meet before one of them changes its cell.
class Grid
{
public:

    /// cell_size  at least the diameter of the largest body that moves, and finite  [m]
    /// columns, rows  of the torus: powers of two, >= 4
    /// bodies     how many there are; their ids are 0 ... bodies - 1
    Grid(double cell_size, int columns, int rows, int bodies);

    [[nodiscard]] double cell_size() const { return cell_size_; }

    /// The cell that holds a point; |coordinates| below 2^50 cells.
    [[nodiscard]] Cell cell_at(const Vec2& point) const;

    /// Put a body into its first cell.
    void insert(int body, const Cell& cell);
    /// Move a body from its cell to another.
    void move(int body, const Cell& to);
    [[nodiscard]] const Cell& cell_of(int body) const { return cell_of_[body]; }

    /// Name a static body to all that come within `margin` of its box.
    /// box     may be infinite in one direction or both
    /// margin  bounding radius of the largest body that moves  [m]
    void insert_static(int body, const Aabb& box, double margin);

    /// Give the bodies in cells other ids: body k is the one that was body old_ids[k].
    void renumber(std::span<const int> old_ids);

    /// Where a cell lies on a curve that visits all cells and stays near a place for long (Morton's curve).
    [[nodiscard]] std::uint64_t along_curve(const Cell& cell) const;

    /// Static bodies that a body with its centre in this cell may meet.
    [[nodiscard]] std::span<const int> statics_near(const Cell& cell) const { return statics_[heads_[index(cell)].statics]; }

    /// Call visit(other) for every body in this very cell.
    template <typename Visit>
    void for_each_in(const Cell& cell, Visit&& visit) const
    {
        for_each_of(heads_[index(cell)], visit);
    }

    /// Call visit(other) for every body in the nine cells about this one.
    template <typename Visit>
    void for_each_near(const Cell& cell, Visit&& visit) const
    {
        const std::size_t left = index({cell.column - 1, 0});
        const std::size_t middle = index({cell.column, 0});
        const std::size_t right = index({cell.column + 1, 0});
        for (std::int64_t row = cell.row - 1; row <= cell.row + 1; ++row) {
            const Head* const line = &heads_[index({0, row})];
            for (const std::size_t column : {left, middle, right})
                for_each_of(line[column], visit);
        }
    }

    /// Write down the bodies in the nine cells about this one, in the order of `for_each_near`. What a cell holds
    /// can't be guessed, and so nothing here waits for a guess, but in cells that hold more than two.
    /// near  room for one more than all bodies. Returns the end of the list.
    [[nodiscard]] int* gather_near(const Cell& cell, int* near) const
    {
        const std::size_t left = index({cell.column - 1, 0});
        const std::size_t middle = index({cell.column, 0});
        const std::size_t right = index({cell.column + 1, 0});
        for (std::int64_t row = cell.row - 1; row <= cell.row + 1; ++row) {
            const Head* const line = &heads_[index({0, row})];
            for (const std::size_t column : {left, middle, right}) {
                const Head& head = line[column];
                for (const int body : head.bodies) {
                    *near = body;
                    near += body >= 0 ? 1 : 0;
                }
                for (int other = head.chain; other >= 0; other = next_[other]) *near++ = other;
            }
        }
        return near;
    }

    /// Ask the memory for what a visit to the cells about this one will read: first the cells, later the bodies' places in
    /// them. Hints, which cost little and change nothing.
    [[gnu::always_inline]] void fetch_near(const Cell& cell) const
    {
        for (std::int64_t row = cell.row - 1; row <= cell.row + 1; ++row) {
            fetch(&heads_[index({cell.column - 1, row})]);
            fetch(&heads_[index({cell.column + 1, row})]);
        }
    }
    void fetch_cell_of(int body) const { fetch(&cell_of_[body]); }

private:

    /// What a cell knows. Two bodies have their names in the cell itself, where they are at hand; the others form a chain.
    struct alignas(16) Head
    {
        std::array<int, 2> bodies = {-1, -1}; // -1 where there is none; the second place is filled after the first
        int chain = -1;                       // first of the others
        int statics = 0;                      // index of its list of static bodies
    };

    template <typename Visit>
    void for_each_of(const Head& head, Visit&& visit) const
    {
        if (head.bodies[0] < 0) return;
        visit(head.bodies[0]);
        if (head.bodies[1] < 0) return;
        visit(head.bodies[1]);
        for (int other = head.chain; other >= 0; other = next_[other]) visit(other);
    }

    [[nodiscard]] std::size_t index(const Cell& cell) const
    {
        const auto column = static_cast<std::uint64_t>(cell.column) & column_mask_;
        const auto row = static_cast<std::uint64_t>(cell.row) & row_mask_;
        return static_cast<std::size_t>((row << row_shift_) | column);
    }

    double cell_size_;
    std::uint64_t column_mask_;
    std::uint64_t row_mask_;
    int row_shift_;
    std::vector<Head> heads_; // of each cell
    std::vector<int> next_;   // of each body that is in a chain
    std::vector<Cell> cell_of_;
    std::vector<std::vector<int>> statics_; // lists that cells name; the first is empty
};

/// A grid fit for bodies spread over `extent`: about half a body to a cell, no cell smaller than a body.
/// largest_radius  bounding radius of the largest body that moves [m]
/// bodies          how many there are
/// movers          how many of them move
[[nodiscard]] Grid make_grid(const Aabb& extent, double largest_radius, int bodies, int movers);

} // namespace flying
