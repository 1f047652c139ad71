#pragma once

#include "broadphase/grid.hpp"
#include "toi/prediction.hpp"

namespace flying {

// [events.cell_exit.result]
/// When a body leaves its cell, and for which.
struct CellExit
{
    double time = k_never; ///< [s]
    Cell to;
};
// [events.cell_exit.result]

// [events.cell_exit]
/// First time, not before `now`, at which a flyer crosses a border of its cell outwards. Only the direction of crossing
/// counts, so that a body that stands on the border by rounding is not sent back and forth.
[[nodiscard]] inline CellExit next_cell_exit(const Flyer& flyer, const Cell& cell, double cell_size, double now)
{
    CellExit exit;
    // [events.cell_exit.crossing]
    const auto consider = [&](double room, double speed, double acceleration, Cell to) {
        // `room` is the distance to the border; it falls through zero when the body crosses
        double time = flyer.state.time + falling_root(room, -speed, -acceleration);

        // A crossing in the past was undone by a later one, or it is still under way
        if (time < now) {
            const bool outwards = speed + acceleration * (now - flyer.state.time) > 0.0;
            time = outwards ? now : k_never;
        }
        if (time < exit.time) exit = {time, to};
    };
    // [events.cell_exit.crossing]
    // [events.cell_exit.borders]
    const auto column = static_cast<double>(cell.column);
    const auto row = static_cast<double>(cell.row);
    const Vec2& x = flyer.state.position;
    const Vec2& v = flyer.state.velocity;
    const Vec2& a = flyer.acceleration;
    consider((column + 1.0) * cell_size - x.x(), v.x(), a.x(), {cell.column + 1, cell.row});
    consider(x.x() - column * cell_size, -v.x(), -a.x(), {cell.column - 1, cell.row});
    consider((row + 1.0) * cell_size - x.y(), v.y(), a.y(), {cell.column, cell.row + 1});
    consider(x.y() - row * cell_size, -v.y(), -a.y(), {cell.column, cell.row - 1});
    // [events.cell_exit.borders]
    return exit;
}
// [events.cell_exit]

} // namespace flying
